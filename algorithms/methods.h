#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "algorithms/estimator.h"
#include "core/config/configured.h"
#include "core/config/settings.h"
#include "core/random.h"

namespace mapbed {

using ConfiguredMethod = Configured<std::unique_ptr<Estimator>(const Given&, Rng)>;

// A method by name. `configure` binds settings to its options; it throws InputError on a wrong one.
struct Method {
  std::string name;
  std::string about;
  std::function<ConfiguredMethod(const Settings&)> configure;
  bool labels_beams = false;    // its estimates have labels
  bool has_graph = false;       // they have a pose graph, and associations where it searches them
  bool needs_odometry = false;  // has nothing else to go by
  bool needs_map = false;       // makes none: Given::map
};

const std::vector<Method>& methods();

// Throws InputError for an unknown name, with the nearest one.
const Method& method_by_name(const std::string& name);

}  // namespace mapbed
