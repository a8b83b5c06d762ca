#pragma once

#include <optional>
#include <vector>

#include "core/sensor/measurement.h"

namespace mapbed {

// Odometry that comes between scans tells where the robot is at a scan once the reading after it is
// there. Scans wait for that, as drivers of robots do, and the reading between the two goes before
// them. A scan waits until others are kLongest younger, and not at all in a log that has no
// odometry. Readings may be far apart where scans are, too; scans that were let go without a
// reading show that odometry was out, and between the readings about that nothing is made up.
class OdometryAtScans {
 public:
  // What may go on, in order of time.
  std::vector<Measurement> add(Measurement measurement);
  // What still waits.
  std::vector<Measurement> finish();

 private:
  static constexpr double kLongest = 1.5;  // [s]

  std::vector<Measurement> released_by(const Odometry& reading);

  std::optional<Odometry> before_;
  bool is_out_ = false;               // since before_ scans went on without
  std::vector<Measurement> waiting_;  // scans, oldest first
};

}  // namespace mapbed
