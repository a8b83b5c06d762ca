#pragma once

#include <optional>
#include <vector>

#include "core/sensor/measurement.h"

namespace mapbed {

// Odometry that comes between scans tells where the robot is at a scan once the reading after it is
// there. Scans wait for that, as drivers of robots do, and the reading between the two goes before
// them. A scan waits for kLongest at most, and not at all in a log that has no odometry.
class OdometryAtScans {
 public:
  // What may go on, in order of time.
  std::vector<Measurement> add(Measurement measurement);
  // What still waits.
  std::vector<Measurement> finish();

 private:
  static constexpr double kLongest = 1.5;  // [s] between readings that tell what was between them

  std::vector<Measurement> released_by(const Odometry& reading);

  std::optional<Odometry> before_;
  std::vector<Measurement> waiting_;  // scans, oldest first
};

}  // namespace mapbed
