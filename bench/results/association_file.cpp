#include "bench/results/association_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/check.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

using Json = nlohmann::ordered_json;
using Tree = AssociationTree;

constexpr double kImpossible = -std::numeric_limits<double>::infinity();

Json json_of(const Tree::Node& node) {
  return {{"parent", node.parent},         {"local_map", node.local_map},
          {"associated", node.associated}, {"log_likelihood", node.log_likelihood},
          {"expanded", node.expanded},     {"newest", node.newest}};
}

Json json_of(const Tree::Choice& choice) {
  return {{"time", choice.time},
          {"node", choice.node},
          {"log_likelihood", choice.log_likelihood},
          {"newest", choice.newest}};
}

Json json_of(const Tree& tree, const Tree::Revision& revision) {
  Json json{{"time", revision.time},
            {"at", revision.at},
            {"since", revision.since},
            {"changed", revision.changed},
            {"before", revision.before},
            {"after", revision.after},
            {"log_likelihood_before", revision.log_likelihood_before},
            {"log_likelihood_after", revision.log_likelihood_after},
            {"decisions", Json::array()}};
  for (const ChangedDecision& decision : changed_decisions(tree, revision)) {
    json["decisions"].push_back({{"local_map", decision.local_map},
                                 {"before", decision.before},
                                 {"after", decision.after}});
  }
  return json;
}

// A line for each item.
template <class Items, class ToJson>
std::string lines_of(const Items& items, const ToJson& to_json) {
  std::string text = "[";
  for (const auto& item : items) {
    text += (text.size() == 1 ? "\n    " : ",\n    ") + Json(to_json(item)).dump();
  }
  return text + (items.empty() ? "]" : "\n  ]");
}

// The members of an object, whose place in the file errors name: "revisions[2]".
class Members {
 public:
  Members(const Json& json, std::string file, std::string place)
      : json_(json), file_(std::move(file)), place_(std::move(place)) {
    if (!json_.is_object()) fail("is not an object");
  }

  const Json& list(const char* name) const {
    const Json& value = member(name);
    if (!value.is_array()) fail(fmt::format("'{}' is not a list", name));
    return value;
  }

  double number(const char* name) const {
    const Json& value = member(name);
    if (!value.is_number()) fail(fmt::format("'{}' is not a number", name));
    return value.get<double>();
  }

  double log_likelihood(const char* name) const {
    return member(name).is_null() ? kImpossible : number(name);
  }

  // In [low, high).
  int integer(const char* name, std::int64_t low, std::int64_t high) const {
    const Json& value = member(name);
    if (!value.is_number_integer()) fail(fmt::format("'{}' is not a whole number", name));
    const auto number = value.get<std::int64_t>();
    if (number < low || number >= high) {
      fail(fmt::format("'{}' is {}, there is none of that number here", name, number));
    }
    return static_cast<int>(number);
  }

  bool truth(const char* name) const {
    const Json& value = member(name);
    if (!value.is_boolean()) fail(fmt::format("'{}' is neither true nor false", name));
    return value.get<bool>();
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError({file_}, place_.empty() ? reason : place_ + ": " + reason);
  }

 private:
  const Json& member(const char* name) const {
    const auto found = json_.find(name);
    if (found == json_.end()) fail(fmt::format("has no '{}'", name));
    return *found;
  }

  const Json& json_;
  std::string file_, place_;
};

class Reader {
 public:
  Reader(const Json& json, std::string name) : file_(std::move(name)), json_(json, file_, "") {}

  Tree tree() {
    read_local_maps();
    read_nodes();
    each("choices", [&](const Members& m) {
      tree_.choices.push_back({.time = m.number("time"),
                               .node = node(m, "node"),
                               .log_likelihood = m.log_likelihood("log_likelihood"),
                               .newest = m.log_likelihood("newest")});
    });
    each("revisions", [&](const Members& m) {
      tree_.revisions.push_back({.time = m.number("time"),
                                 .at = local_map(m, "at"),
                                 .since = local_map(m, "since"),
                                 .changed = m.integer("changed", 0, maps() + 1),
                                 .before = node(m, "before"),
                                 .after = node(m, "after"),
                                 .log_likelihood_before = m.log_likelihood("log_likelihood_before"),
                                 .log_likelihood_after = m.log_likelihood("log_likelihood_after")});
    });
    tree_.chosen = tree_.nodes.empty() ? static_cast<std::size_t>(json_.integer("chosen", 0, 1))
                                       : node(json_, "chosen");
    tree_.given_up = json_.integer("given_up", 0, std::numeric_limits<int>::max());
    return std::move(tree_);
  }

 private:
  template <class Take>
  void each(const char* name, const Take& take) const {
    int number = 0;
    for (const Json& item : json_.list(name)) {
      take(Members(item, file_, fmt::format("{}[{}]", name, number++)));
    }
  }

  void read_local_maps() {
    for (const Json& item : json_.list("local_maps")) {
      const bool is_interval =
          item.is_array() && item.size() == 2 && item[0].is_number() && item[1].is_number();
      if (!is_interval) json_.fail("'local_maps' is not a list of pairs of times");
      tree_.local_maps.push_back({item[0].get<double>(), item[1].get<double>()});
    }
  }

  void read_nodes() {
    each("nodes", [&](const Members& m) {
      const int parent = m.integer("parent", -1, count(tree_.nodes));
      const int about = local_map(m, "local_map");
      const int before = parent < 0 ? -1 : tree_.nodes[static_cast<std::size_t>(parent)].local_map;
      if (about <= before) m.fail("is about no later local map than its parent");
      tree_.nodes.push_back({.parent = parent,
                             .local_map = about,
                             .associated = m.integer("associated", -1, about),
                             .log_likelihood = m.log_likelihood("log_likelihood"),
                             .expanded = m.truth("expanded"),
                             .newest = m.log_likelihood("newest")});
    });
  }

  template <class Items>
  static std::int64_t count(const Items& items) {
    return static_cast<std::int64_t>(items.size());
  }
  std::int64_t maps() const { return count(tree_.local_maps); }
  int local_map(const Members& m, const char* name) const { return m.integer(name, 0, maps()); }
  std::size_t node(const Members& m, const char* name) const {
    return static_cast<std::size_t>(m.integer(name, 0, count(tree_.nodes)));
  }

  std::string file_;
  Members json_;
  Tree tree_;
};

}  // namespace

std::string associations_json(const AssociationTree& tree) {
  const auto simply = [](const auto& item) { return json_of(item); };
  return fmt::format(
      "{{\n  \"local_maps\": {},\n  \"nodes\": {},\n  \"chosen\": {},\n  \"choices\": {},\n"
      "  \"revisions\": {},\n  \"given_up\": {}\n}}\n",
      lines_of(tree.local_maps,
               [](const TimeInterval& made) {
                 return Json::array({made.from, made.to});
               }),
      lines_of(tree.nodes, simply), tree.chosen, lines_of(tree.choices, simply),
      lines_of(tree.revisions, [&](const Tree::Revision& r) { return json_of(tree, r); }),
      tree.given_up);
}

AssociationTree parse_associations(const std::string& name, std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) throw InputError({name}, "is not JSON, or was cut short");
  return Reader(json, name).tree();
}

std::vector<std::size_t> path_to(const AssociationTree& tree, std::size_t node) {
  if (tree.nodes.empty()) return {};
  std::vector<std::size_t> path{node};
  while (tree.nodes.at(path.back()).parent >= 0) {
    path.push_back(static_cast<std::size_t>(tree.nodes[path.back()].parent));
  }
  std::reverse(path.begin(), path.end());
  return path;
}

std::vector<ChangedDecision> changed_decisions(const AssociationTree& tree,
                                               const AssociationTree::Revision& revision) {
  std::map<int, ChangedDecision> by_map;
  for (const std::size_t node : path_to(tree, revision.before)) {
    const Tree::Node& n = tree.nodes[node];
    by_map[n.local_map] = {n.local_map, n.associated, n.associated};
  }
  for (const std::size_t node : path_to(tree, revision.after)) {
    const auto decided = by_map.find(tree.nodes[node].local_map);
    if (decided != by_map.end()) decided->second.after = tree.nodes[node].associated;
  }
  std::vector<ChangedDecision> changed;
  for (const auto& [local_map, decision] : by_map) {
    if (decision.before != decision.after) changed.push_back(decision);
  }
  return changed;
}

}  // namespace mapbed
