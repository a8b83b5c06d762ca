#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/config/settings.h"
#include "core/geometry/trajectory.h"
#include "core/random.h"
#include "core/sensor/measurement.h"

namespace mapbed {

// What a method believes at some point in time.
struct Estimate {
  Trajectory trajectory;  // map_from_robot at the stamp of every scan added so far, in order
  int untrusted_scans =
      0;  // scans whose pose is the prediction alone: the match was not trustworthy
  std::vector<std::string>
      remarks;  // what the user should know ("no odometry from 12.3 s to 22.4 s")
};

// How many possibilities a particle filter still holds, at one of its updates.
struct Diversity {
  double time = 0.0;              // [s]
  int distinct_ancestors = 0;     // of today's particles among those of that update
  double effective_number = 0.0;  // after weighting, before resampling
  bool resampled = false;
};

// What a method with several hypotheses holds besides its estimate; empty for all others.
struct Hypotheses {
  // map_from_robot of all paths that are held possible. What several have in common stands there
  // once: each branch begins where it parted from one before it.
  std::vector<Trajectory> branches;
  std::vector<Diversity> diversity;  // at each update so far
};

// The one interface behind which methods are exchanged: measurements in, belief out, at any time.
class Estimator {
 public:
  virtual ~Estimator() = default;
  virtual void add(const Measurement& measurement) = 0;  // in order of time
  virtual Pose2 pose() const = 0;  // map_from_robot now; cheap. Identity before the first scan
  virtual Estimate estimate() const = 0;  // the whole path, as it is believed now
  virtual Hypotheses hypotheses() const { return {}; }
};

// A method by name. `options` applies the settings and lists what holds then, for `describe` and
// for the configuration written beside the results; `make` gives the method with them.
struct Method {
  std::string name;
  std::string about;
  std::function<std::string(const Settings&)> complete_yaml;
  std::function<std::unique_ptr<Estimator>(const Settings&, Rng)> make;
};

const std::vector<Method>& methods();

// Throws InputError for an unknown name (with the nearest one) or a wrong setting.
const Method& method_by_name(const std::string& name);

}  // namespace mapbed
