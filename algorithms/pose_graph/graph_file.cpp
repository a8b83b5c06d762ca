#include "algorithms/pose_graph/graph_file.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "algorithms/pose_graph/graph_lines.h"
#include "core/file/text_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr const char* kForms =
    "lines are VERTEX_SE2 and EDGE_SE2, VERTEX_SE3:QUAT and EDGE_SE3:QUAT (g2o), or VERTEX2 and "
    "EDGE2, VERTEX3 and EDGE3 (TORO)";

template <class Pose>
struct Lines {
  struct Node {
    Pose pose;
    long line = 0;
  };
  struct Edge {
    std::int64_t from = 0, to = 0;
    PoseConstraint<Pose> constraint;
    long line = 0;
  };
  std::map<std::int64_t, Node> nodes;
  std::vector<Edge> edges;
};

// All that lines say, before nodes have numbers.
struct Content {
  Lines<Pose2> plane;
  Lines<Pose3> space;
  std::optional<std::pair<GraphKind, long>> first;  // line that says which of both it is
  bool is_in_space = false;
  std::vector<std::pair<std::int64_t, long>> held;
  std::map<std::string, int> unknown;  // tags, and how many lines begin with them
  std::vector<std::string> remarks;

  template <class Pose>
  Lines<Pose>& of() {
    if constexpr (std::is_same_v<Pose, Pose2>)
      return plane;
    else
      return space;
  }
};

template <class Pose>
void add_node(Content& content, GraphKind kind, Tokens& tokens, const SourceLocation& place) {
  auto& nodes = content.of<Pose>().nodes;
  const std::int64_t id = read_id(tokens, place);
  const Pose pose = read_pose<Pose>(kind, tokens, place);
  check_line_end(tokens, place);
  const auto [node, is_new] = nodes.emplace(id, typename Lines<Pose>::Node{pose, place.line});
  if (is_new) return;
  if (!(node->second.pose == pose)) {
    throw InputError(place,
                     fmt::format("node {} has another pose in line {}", id, node->second.line),
                     "leave one of them");
  }
  content.remarks.push_back(
      fmt::format("line {}: node {} is given twice, with the same pose", place.line, id));
}

template <class Pose>
void add_edge(Content& content, GraphKind kind, Tokens& tokens, const SourceLocation& place) {
  typename Lines<Pose>::Edge edge;
  edge.from = read_id(tokens, place);
  edge.to = read_id(tokens, place);
  edge.constraint.from_from_to = read_pose<Pose>(kind, tokens, place);
  edge.constraint.information = read_information<Pose>(kind, tokens, place);
  edge.line = place.line;
  check_line_end(tokens, place);
  if (edge.from == edge.to) {
    content.remarks.push_back(
        fmt::format("line {}: an edge from node {} to itself is left out", place.line, edge.from));
    return;
  }
  content.of<Pose>().edges.push_back(edge);
}

void add_line(Content& content, std::string_view line, const SourceLocation& place) {
  Tokens tokens(line);
  if (tokens.at_end()) return;
  const std::string_view tag = tokens.word();
  if (tag.front() == '#') return;
  if (tag == "FIX") {
    while (!tokens.at_end()) content.held.emplace_back(read_id(tokens, place), place.line);
    return;
  }
  const std::optional<GraphKind> kind = graph_kind(tag);
  if (!kind) {
    if (!tag.starts_with("PARAMS")) ++content.unknown[std::string(tag.substr(0, 40))];
    return;
  }
  if (!content.first) content.first = {*kind, place.line};
  if (kind->is_in_space != content.first->first.is_in_space) {
    throw InputError(
        place,
        fmt::format("{} is {}, line {} is {}", tag, kind->is_in_space ? "in space" : "in the plane",
                    content.first->second, kind->is_in_space ? "in the plane" : "in space"),
        "a graph is in one of both; make two files of it");
  }
  if (kind->is_in_space) {
    kind->is_edge ? add_edge<Pose3>(content, *kind, tokens, place)
                  : add_node<Pose3>(content, *kind, tokens, place);
  } else {
    kind->is_edge ? add_edge<Pose2>(content, *kind, tokens, place)
                  : add_node<Pose2>(content, *kind, tokens, place);
  }
}

bool closes_loop(LoopRule rule, std::int64_t from, std::int64_t to) {
  switch (rule) {
    case LoopRule::all:
      return true;
    case LoopRule::none:
      return false;
    case LoopRule::not_consecutive:
      break;
  }
  return from < to ? to - 1 != from : from - 1 != to;
}

template <class Pose>
void number_nodes(const std::string& name, Lines<Pose>& lines, GraphFile& file,
                  PoseGraph<Pose>& graph) {
  file.has_poses = !lines.nodes.empty();
  if (!file.has_poses) {
    for (const auto& edge : lines.edges) {
      lines.nodes[edge.from];
      lines.nodes[edge.to];
    }
  }
  if (lines.nodes.empty()) throw InputError({name}, "holds no node", "are its edges complete?");
  for (const auto& edge : lines.edges) {
    for (const std::int64_t id : {edge.from, edge.to}) {
      if (lines.nodes.contains(id)) continue;
      throw InputError({name, edge.line},
                       fmt::format("an edge joins node {}, which has no vertex", id),
                       "add its vertex, or leave all vertices out: then poses are found from the "
                       "edges alone");
    }
  }
  for (const auto& [id, node] : lines.nodes) {
    file.ids.push_back(id);
    graph.nodes.push_back(node.pose);
  }
}

int number_of_node(const std::vector<std::int64_t>& ids, std::int64_t id) {
  const auto found = std::lower_bound(ids.begin(), ids.end(), id);
  return found != ids.end() && *found == id ? static_cast<int>(found - ids.begin()) : -1;
}

template <class Pose>
PoseGraph<Pose> assembled(const std::string& name, Content& content, LoopRule rule,
                          GraphFile& file) {
  PoseGraph<Pose> graph;
  Lines<Pose>& lines = content.of<Pose>();
  number_nodes(name, lines, file, graph);
  std::set<std::pair<std::int64_t, std::int64_t>> joined;
  int repeated = 0;
  for (auto& edge : lines.edges) {
    edge.constraint.from = number_of_node(file.ids, edge.from);
    edge.constraint.to = number_of_node(file.ids, edge.to);
    edge.constraint.closes_loop = closes_loop(rule, edge.from, edge.to);
    graph.constraints.push_back(edge.constraint);
    if (!joined.insert(std::minmax(edge.from, edge.to)).second) ++repeated;
  }
  for (const auto& [id, line] : content.held) {
    const int node = number_of_node(file.ids, id);
    if (node < 0) {
      throw InputError({name, line}, fmt::format("FIX names node {}, which there is not", id),
                       "add its vertex or leave the line out");
    }
    graph.held.push_back(node);
  }
  if (repeated > 0) {
    content.remarks.push_back(fmt::format(
        "edges between nodes that another edge joins already: {}; each counts", repeated));
  }
  return graph;
}

}  // namespace

GraphFile parse_graph(const std::string& name, std::string_view text,
                      const GraphFileOptions& options) {
  Content content;
  SourceLocation place{name, 0};
  while (!text.empty()) {
    ++place.line;
    add_line(content, next_line(text), place);
  }
  if (!content.first) throw InputError({name}, "holds no pose graph", kForms);
  GraphFile file;
  file.format = content.first->first.is_toro ? GraphFormat::toro : GraphFormat::g2o;
  if (content.first->first.is_in_space) {
    file.graph = assembled<Pose3>(name, content, options.loops, file);
  } else {
    file.graph = assembled<Pose2>(name, content, options.loops, file);
  }
  for (const auto& [tag, count] : content.unknown) {
    content.remarks.push_back(fmt::format(
        "lines {} are left out, as nothing is known of them here: {}", in_quotes(tag), count));
  }
  file.remarks = std::move(content.remarks);
  return file;
}

GraphFile load_graph(const std::string& path, const GraphFileOptions& options) {
  return parse_graph(path, read_text_file(path), options);
}

}  // namespace mapbed
