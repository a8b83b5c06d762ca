#pragma once

#include <string>
#include <utility>
#include <vector>

#include "algorithms/methods.h"

namespace mapbed {

// Settings of an experiment that runs a method which `estimator` names: those of methods stand
// under the method's name.
struct MethodSettings {
  Settings own;                                              // of the experiment, with `estimator`
  std::vector<std::pair<std::string, Settings>> of_methods;  // without the name in front
};

MethodSettings divided_by_method(const Settings& settings);

// Settings of other methods are checked as well. Throws InputError.
ConfiguredMethod chosen_method(const std::string& estimator, const MethodSettings& settings);

// The options of the method under its name.
std::string method_yaml(const std::string& estimator, const ConfiguredMethod& method);

}  // namespace mapbed
