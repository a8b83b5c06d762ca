#include "bench/cli/map_config.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace mapbed {
namespace {

// "scan_matching" of "scan_matching.first_step".
std::string group_of(const Setting& setting) {
  return setting.path.substr(0, setting.path.find('.'));
}

bool is_method(const std::string& name) {
  return std::any_of(methods().begin(), methods().end(),
                     [&](const Method& method) { return method.name == name; });
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

MapConfig map_config_from(const Settings& settings, MapConfig config) {
  Settings own;
  Settings of_methods;
  for (const Setting& setting : settings) {
    (is_method(group_of(setting)) ? of_methods : own).push_back(setting);
  }
  for (const Setting& setting : own) {
    if (setting.path == "method") config.method = setting.text;
  }
  const Method& method = method_by_name(config.method);
  check_group_is_named(own, method);
  apply(own, options_of(config), "");
  Settings of_method;
  for (Setting setting : of_methods) {
    const std::string group = group_of(setting);
    if (group != config.method) {
      throw InputError(setting.place,
                       "'" + setting.path + "' is set, but the method is " + config.method,
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
  config.configured = method.configure(with_refinement(method, std::move(of_method)));
  return config;
}

std::string to_yaml(MapConfig config) {
  return to_yaml(options_of(config)) + config.method + ":  # " +
         method_by_name(config.method).about + "\n" + indented(config.configured.complete_yaml);
}

}  // namespace mapbed
