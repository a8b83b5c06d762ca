#pragma once

#include <optional>

#include "core/sensor/odometry.h"

namespace mapbed {

// The newest odometry, and from it the robot's motion between the stamps of scans. Works online: a
// stamp after the newest reading is reached with the velocity between the last two.
class OdometryTrack {
 public:
  void add(const Odometry& odometry);

  // odometry_from_robot at a stamp not before the reading before last; none where there is no
  // reading, or the newest is older than max_age.
  std::optional<Pose2> at(double time) const;

 private:
  static constexpr double kMaxAge = 1.0;  // [s]
  std::optional<Odometry> before_;
  std::optional<Odometry> newest_;
};

}  // namespace mapbed
