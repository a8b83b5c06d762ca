#include "core/config/settings.h"

#include <algorithm>
#include <unordered_map>

#include "core/config/config_node.h"
#include "core/config/renamed_options.h"
#include "core/config/set_option.h"
#include "core/config/suggestion.h"
#include "core/data_path.h"

namespace mapbed {
namespace {

bool is_valid_path(std::string_view path) {
  return !path.empty() && path.front() != '.' && path.back() != '.' &&
         path.find("..") == std::string_view::npos &&
         path.find_first_of(" \t\n[]{}") == std::string_view::npos;
}

void collect_leaves(const ConfigNode& node, const std::string& path, Settings& leaves) {
  if (node.kind() != ConfigNode::Kind::map || (node.keys().empty() && !path.empty())) {
    const std::string text = node.flow_text();
    const bool is_value = node.kind() == ConfigNode::Kind::value;
    leaves.push_back({path, is_value ? with_whole_path(text, node.place()) : text, node.place()});
    node.use_all();  // the entries of a list
    return;
  }
  for (const std::string& key : node.keys()) {
    collect_leaves(node.at(key), path.empty() ? key : path + "." + key, leaves);
  }
}

// The names that come directly below a group of options; of the outermost group if it is empty.
std::vector<std::string> names_in(const std::string& group, const OptionList& options) {
  const std::string prefix = group.empty() ? "" : group + ".";
  std::vector<std::string> names;
  for (const Option& option : options) {
    if (!option.path.starts_with(prefix)) continue;
    const std::string rest = option.path.substr(prefix.size());
    const std::string name = rest.substr(0, rest.find('.'));
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

[[noreturn]] void throw_unknown(const Setting& setting, const OptionList& options,
                                const std::string& context) {
  if (const auto renaming = renaming_of(setting.path, context)) {
    throw InputError(setting.place, *renaming);
  }
  // walk down as far as the path names groups that exist
  std::string group;
  std::vector<std::string> known = names_in(group, options);
  std::size_t start = 0;
  for (;;) {
    const std::size_t dot = setting.path.find('.', start);
    const std::string key = setting.path.substr(start, dot - start);
    const std::string where =
        context.empty() || group.empty() ? context + group : context + "." + group;
    const std::string in = where.empty() ? "" : " in " + where;
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      throw InputError(setting.place, "unknown key " + in_quotes(key) + in, suggestion(key, known));
    }
    group += (group.empty() ? "" : ".") + key;
    known = names_in(group, options);
    if (known.empty()) {
      throw InputError(setting.place, in_quotes(key) + in + " takes one value and has no keys");
    }
    if (dot == std::string::npos) {
      throw InputError(setting.place, in_quotes(key) + in + " has keys and takes no value",
                       "set e.g. '" + group + "." + known.front() + "'");
    }
    start = dot + 1;
  }
}

bool is_group(const std::string& path, const OptionList& options) {
  return std::any_of(options.begin(), options.end(),
                     [&](const Option& o) { return o.path.starts_with(path + "."); });
}

}  // namespace

Setting parse_setting(const std::string& assignment) {
  const SourceLocation place{"--set " + assignment, 0};
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) {
    throw InputError(place, "there is no '='", "write path=value, e.g. 'seeds=10'");
  }
  const std::string value = with_whole_path(assignment.substr(equals + 1), place);
  Setting setting{assignment.substr(0, equals), value, place};
  if (!is_valid_path(setting.path)) {
    throw InputError(place, in_quotes(setting.path) + " is not the path of an option",
                     "write path=value, e.g. 'robot.odometry.rotation_sigma=2 deg'");
  }
  return setting;
}

Settings settings_of(const ConfigNode& node) {
  Settings leaves;
  if (node.kind() != ConfigNode::Kind::map) (void)node.keys();  // throws with place and remedy
  collect_leaves(node, "", leaves);
  std::unordered_map<std::string, long> first_line;
  for (const Setting& setting : leaves) {
    if (!is_valid_path(setting.path)) {
      throw InputError(setting.place, in_quotes(setting.path) + " is not the path of an option");
    }
    const auto [earlier, is_new] = first_line.emplace(setting.path, setting.place.line);
    if (is_new) continue;
    throw InputError(
        setting.place,
        in_quotes(setting.path) + " was already set in line " + std::to_string(earlier->second),
        "keep one of them");
  }
  return leaves;
}

Settings settings_of(const std::string& key, const ConfigNode& node) {
  Settings leaves;
  if (node.kind() != ConfigNode::Kind::map) {
    collect_leaves(node, key, leaves);
    return leaves;
  }
  leaves = settings_of(node);
  for (Setting& setting : leaves) setting.path = key + "." + setting.path;
  return leaves;
}

Settings load_settings(const std::string& yaml_path) {
  return settings_of(load_config(yaml_path));
}

void apply(const Settings& settings, const OptionList& options, const std::string& context) {
  for (const Setting& setting : settings) {
    const auto option = std::find_if(options.begin(), options.end(),
                                     [&](const Option& o) { return o.path == setting.path; });
    if (option == options.end()) {
      if (setting.text == "{}" && is_group(setting.path, options)) continue;  // nothing differs
      throw_unknown(setting, options, context);
    }
    if (is_list(*option) && setting.text.starts_with("[")) {
      set_option(*option, parse_config(setting.text, setting.place));
    } else {
      set_option(*option, ConfigNode(setting.text, setting.place));
    }
  }
}

void read_options(const ConfigNode& node, const OptionList& options) {
  for (const Option& option : options) {
    const ConfigNode* at = &node;
    for (std::size_t start = 0; at != nullptr && start != std::string::npos;) {
      const std::size_t dot = option.path.find('.', start);
      at = at->find(std::string_view(option.path).substr(start, dot - start));
      start = dot == std::string::npos ? dot : dot + 1;
    }
    if (at != nullptr) set_option(option, *at);
  }
}

}  // namespace mapbed
