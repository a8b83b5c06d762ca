#include "bench/cli/map_config.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "bench/methods/people_filter.h"
#include "core/data_path.h"

namespace mapbed {
namespace {

// "scan_matching" of "scan_matching.first_step".
std::string group_of(const Setting& setting) {
  return setting.path.substr(0, setting.path.find('.'));
}

bool is_ours(const std::string& name) {
  return std::any_of(methods().begin(), methods().end(),
                     [&](const Method& method) { return method.name == name; });
}

// Of ours or of somebody else's; `chosen` may be one that no list has.
bool is_method(const std::string& name, const std::string& chosen) {
  const std::vector<std::string> programs = program_method_names();
  return is_ours(name) || name == chosen ||
         std::find(programs.begin(), programs.end(), name) != programs.end();
}

template <class Try>
bool is_accepted(Try&& apply_it) {
  try {
    apply_it();
    return true;
  } catch (const InputError&) {
    return false;
  }
}

// A map for use is worth the time that refinement takes; comparisons leave it out by default.
Settings with_refinement(const Method& method, Settings of_method) {
  const Setting refined{"refinement.enabled", "true", {}};
  const bool refines = is_accepted([&] { (void)method.configure({refined}); });
  if (refines) of_method.insert(of_method.begin(), refined);
  return of_method;
}

// 'particles=30' of somebody who means 'rbpf.particles=30'.
void check_group_is_named(const Settings& own, const Method& method) {
  for (const Setting& setting : own) {
    MapConfig config;
    if (is_accepted([&] { apply({setting}, options_of(config), ""); })) continue;
    if (!is_accepted([&] { (void)method.configure({setting}); })) continue;
    throw InputError(setting.place,
                     in_quotes(setting.path) + " is an option of the method " + method.name,
                     "write '" + method.name + "." + setting.path + "'");
  }
}

}  // namespace

MapConfig map_config_from(const Settings& all_settings, MapConfig config) {
  Settings settings = all_settings;
  const Settings of_filter = taken_people_filter(settings);
  SourceLocation of_method_name;
  for (const Setting& setting : settings) {
    if (setting.path != "method") continue;
    config.method = with_whole_path(setting.text, setting.place);
    of_method_name = setting.place;
  }
  const std::string chosen =
      is_program_method(config.method) ? program_method_name(config.method) : config.method;
  Settings own;
  Settings of_methods;
  for (const Setting& setting : settings) {
    if (setting.path == "method") continue;
    (is_method(group_of(setting), chosen) ? of_methods : own).push_back(setting);
  }
  if (is_ours(chosen)) check_group_is_named(own, method_by_name(chosen));
  apply(own, options_of(config), "");
  Settings of_method;
  for (Setting setting : of_methods) {
    const std::string group = group_of(setting);
    if (group != chosen) {
      throw InputError(setting.place, "'" + setting.path + "' is set, but the method is " + chosen,
                       "take it out, or choose '--method " + group + "'");
    }
    if (setting.path == group) {
      if (setting.text == "{}") continue;
      throw InputError(setting.place, "'" + group + "' has keys and takes no value",
                       "'mapbed describe " + group + "' lists them");
    }
    setting.path.erase(0, group.size() + 1);
    of_method.push_back(std::move(setting));
  }
  if (is_ours(chosen)) of_method = with_refinement(method_by_name(chosen), std::move(of_method));
  config.chosen =
      with_people_filter(choose_method(config.method, of_method, of_method_name), of_filter);
  return config;
}

std::string to_yaml(MapConfig config) {
  const std::string of_method = method_yaml(config.chosen);
  const std::size_t name = config.chosen.name.size();
  return to_yaml(options_of(config)) + config.chosen.name + ":  # " + config.chosen.about +
         of_method.substr(name + 1);
}

}  // namespace mapbed
