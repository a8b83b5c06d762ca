#pragma once

#include <optional>
#include <vector>

#include "core/log/sensor_log.h"

namespace mapbed {

// The odometry of a whole log, to be asked at any stamp.
class ToldOdometry {
 public:
  explicit ToldOdometry(const SensorLog& log);

  // odometry_from_robot, between two readings linearly; none outside of the log and in a gap of
  // more than kLongestGap.
  std::optional<Pose2> at(double time) const;
  // From one stamp to another.
  std::optional<Pose2> motion(double from, double to) const;
  // Stamps of readings of which nobody knows how the robot came there: Odometry::motion_unknown.
  std::vector<double> unknown() const;

  static constexpr double kLongestGap =
      1.5;  // [s] between readings that tell what was between them

 private:
  std::vector<Odometry> readings_;
};

}  // namespace mapbed
