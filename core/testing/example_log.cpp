#include "core/testing/example_log.h"

#include <cmath>

#include "core/testing/test_room.h"

namespace mapbed {
namespace {

double rounded(double value, double steps) {
  return std::round(value * steps) / steps + 0.0;  // no -0
}

Pose2 rounded(const Pose2& pose) {
  return {rounded(pose.x, 1e4), rounded(pose.y, 1e4), rounded(pose.theta, 1e5)};
}

}  // namespace

RecordedLog example_log() {
  DriveOptions options;
  options.laser.max_range = 8.0;
  options.scan_period = 0.5;
  options.start_time = 1e9;
  options.range_sigma = 0.01;
  RecordedLog log = drive_through(example_place(), example_tour(), options, Rng(2003));
  for (Measurement& m : log.measurements) {
    if (auto* scan = std::get_if<LaserScan>(&m)) {
      scan->first_bearing = rounded(scan->first_bearing, 1e9);
      scan->bearing_step = rounded(scan->bearing_step, 1e9);
      for (double& range : scan->ranges) range = rounded(range, 100.0);
      continue;
    }
    auto& odometry = std::get<Odometry>(m);
    odometry.odometry_from_robot = rounded(odometry.odometry_from_robot);
    odometry.forward_velocity = rounded(odometry.forward_velocity, 1e3);
    odometry.turn_velocity = rounded(odometry.turn_velocity, 1e3);
  }
  for (Stamped<Pose2>& truth : log.true_poses) truth.pose = rounded(truth.pose);
  return log;
}

}  // namespace mapbed
