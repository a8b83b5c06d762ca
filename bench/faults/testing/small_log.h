#pragma once

#include <vector>

#include "core/log/sensor_log.h"

namespace mapbed {

// Drives along x at 1 m/s and turns on the spot at 1 rad/s for the last third of its time: an
// odometry reading and a scan of three beams each second, at the seconds 100, 101, …
inline SensorLog small_log(int seconds = 9) {
  SensorLog log;
  Pose2 pose;
  for (int i = 0; i <= seconds; ++i) {
    const bool drives = i <= 2 * seconds / 3;
    if (i > 0) pose = pose * (drives ? Pose2{1.0, 0.0, 0.0} : Pose2{0.0, 0.0, 1.0});
    log.push_back(Odometry{100.0 + i, pose, drives ? 1.0 : 0.0, drives ? 0.0 : 1.0});
    LaserScan scan{.time = 100.0 + i, .first_bearing = -0.5, .bearing_step = 0.5, .max_range = 8.0};
    scan.ranges = {1.0 + i, 2.0, 8.0};
    log.push_back(scan);
  }
  return log;
}

inline std::vector<Odometry> readings_of(const SensorLog& log) {
  std::vector<Odometry> readings;
  for (const Measurement& measurement : log) {
    if (const auto* reading = std::get_if<Odometry>(&measurement)) readings.push_back(*reading);
  }
  return readings;
}

inline std::vector<LaserScan> scans_of(const SensorLog& log) {
  std::vector<LaserScan> scans;
  for (const Measurement& measurement : log) {
    if (const auto* scan = std::get_if<LaserScan>(&measurement)) scans.push_back(*scan);
  }
  return scans;
}

// The steps that odometry tells.
inline std::vector<Pose2> steps_of(const SensorLog& log) {
  std::vector<Pose2> steps;
  const std::vector<Odometry> readings = readings_of(log);
  for (std::size_t i = 1; i < readings.size(); ++i) {
    steps.push_back(
        motion_between(readings[i - 1].odometry_from_robot, readings[i].odometry_from_robot));
  }
  return steps;
}

inline bool are_same(const SensorLog& a, const SensorLog& b) {
  const auto same = [](const Measurement& x, const Measurement& y) {
    if (x.index() != y.index() || time_of(x) != time_of(y)) return false;
    if (const auto* reading = std::get_if<Odometry>(&x)) {
      const auto& other = std::get<Odometry>(y);
      return reading->odometry_from_robot == other.odometry_from_robot &&
             reading->forward_velocity == other.forward_velocity &&
             reading->turn_velocity == other.turn_velocity;
    }
    const auto& scan = std::get<LaserScan>(x);
    const auto& other = std::get<LaserScan>(y);
    return scan.laser == other.laser && scan.robot_from_laser == other.robot_from_laser &&
           scan.first_bearing == other.first_bearing && scan.bearing_step == other.bearing_step &&
           scan.max_range == other.max_range && scan.ranges == other.ranges;
  };
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!same(a[i], b[i])) return false;
  }
  return true;
}

}  // namespace mapbed
