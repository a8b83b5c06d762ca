#include "bench/experiments/chosen_method.h"

#include <algorithm>

#include "core/config/suggestion.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

// As method_by_name, but tells where the name stands.
void check_method(const std::string& name, const Settings& settings) {
  std::vector<std::string> names;
  for (const Method& method : methods()) names.push_back(method.name);
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  SourceLocation place;
  for (const Setting& setting : settings) {
    if (setting.path == "estimator") place = setting.place;
  }
  throw InputError(place, "unknown method " + in_quotes(name), suggestion(name, names));
}

}  // namespace

MethodSettings divided_by_method(const Settings& settings) {
  MethodSettings result;
  for (const Method& method : methods()) result.of_methods.emplace_back(method.name, Settings{});
  for (Setting setting : settings) {
    const auto method =
        std::find_if(result.of_methods.begin(), result.of_methods.end(),
                     [&](const auto& m) { return setting.path.starts_with(m.first + "."); });
    if (method == result.of_methods.end()) {
      result.own.push_back(std::move(setting));
    } else {
      setting.path.erase(0, method->first.size() + 1);
      method->second.push_back(std::move(setting));
    }
  }
  return result;
}

ConfiguredMethod chosen_method(const std::string& estimator, const MethodSettings& settings) {
  check_method(estimator, settings.own);
  ConfiguredMethod chosen;
  for (const auto& [name, of_method] : settings.of_methods) {
    ConfiguredMethod method = method_by_name(name).configure(of_method);
    if (name == estimator) chosen = std::move(method);
  }
  return chosen;
}

std::string method_yaml(const std::string& estimator, const ConfiguredMethod& method) {
  return estimator + ":\n" + indented(method.complete_yaml, 2);
}

}  // namespace mapbed
