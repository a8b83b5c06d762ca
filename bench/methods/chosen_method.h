#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "algorithms/methods.h"
#include "bench/methods/program_method.h"

namespace mapbed {

// What finds the trajectory in a log, by the name that a scenario or `mapbed map` gives: one of
// methods(), or a program of somebody else's.
struct ChosenMethod {
  std::string name = {};  // under which its options stand
  std::string about = {};
  std::string complete_yaml = {};  // these
  InputFiles files = {};           // that were read for it
  std::variant<ConfiguredMethod, ProgramMethod> what = {};
  bool labels_beams = false;     // its estimates have labels
  bool has_graph = false;        // they have a pose graph
  bool needs_odometry = false;   // has nothing else to go by
  bool needs_map = false;        // makes none
  std::string filter = {};       // the people filter in front of it; empty: none
  std::string filter_yaml = {};  // its options

  const ProgramMethod* program() const { return std::get_if<ProgramMethod>(&what); }
};

// Throws InputError for an unknown name, which stands at `place`, and for wrong settings.
ChosenMethod choose_method(const std::string& name_or_path, const Settings& settings,
                           const SourceLocation& place = {});

// Settings of an experiment that runs a method which `estimator` names: those of methods stand
// under the method's name.
struct MethodSettings {
  Settings own = {};                                              // with `estimator`
  std::vector<std::pair<std::string, Settings>> of_methods = {};  // without the name in front
};

MethodSettings divided_by_method(const Settings& settings);

// Settings of other methods are checked as well. Throws InputError.
ChosenMethod chosen_method(const std::string& estimator, const MethodSettings& settings);

// The options of the method under its name, and those of the people filter in front of it.
std::string method_yaml(const ChosenMethod& method);

}  // namespace mapbed
