// A robot with a laser in front and one behind, neither of which sees what the other does.

#include <algorithm>

#include <gtest/gtest.h>

#include "algorithms/rbpf/testing/drives.h"

namespace mapbed {
namespace {

TestLaser quarter_circle(const Pose2& robot_from_laser) {
  return {.beams = 91,
          .first_bearing = -kPi / 4,
          .max_range = 15.0,
          .robot_from_laser = robot_from_laser};
}

// Round the room with the laser in front; the other one sweeps at the same moments.
RecordedLog drive_with(const Pose2& robot_from_rear) {
  const TestRoom room = furnished_room();
  DriveOptions drive;
  drive.laser = quarter_circle({0.2, 0.0, 0.0});
  RecordedLog log =
      drive_through(room, {{-3, -1}, {3, -1}, {3, 1.5}, {-3, 1.5}, {-3, -1}}, drive, Rng(4));
  Rng rng(5);
  SensorLog both;
  for (const Measurement& measurement : log.measurements) {
    both.push_back(measurement);
    const auto* front = std::get_if<LaserScan>(&measurement);
    if (front == nullptr) continue;
    const Pose2 pose = *pose_at(log.true_poses, front->time);
    LaserScan rear = with_range_noise(
        scan_of(room, pose, quarter_circle(robot_from_rear), front->time), drive.range_sigma, rng);
    rear.laser = 1;
    both.push_back(rear);
  }
  log.measurements = std::move(both);
  return log;
}

double largest_error(const RecordedLog& log, const Trajectory& path) {
  const Pose2 first = *pose_at(log.true_poses, path.front().time);
  double largest = 0.0;
  for (const Stamped<Pose2>& at : path) {
    const Pose2 truth = motion_between(first, *pose_at(log.true_poses, at.time));
    largest = std::max(largest, distance(truth, motion_between(path.front().pose, at.pose)));
  }
  return largest;
}

Trajectory odometry_of(const RecordedLog& log) {
  Trajectory path;
  for (const Measurement& measurement : log.measurements) {
    const auto* odometry = std::get_if<Odometry>(&measurement);
    if (odometry != nullptr) path.push_back({odometry->time, odometry->odometry_from_robot});
  }
  return path;
}

// Scans of the rear one that are taken for scans of a laser in front move the path by more than
// 20 cm, and so does odometry alone.
TEST(GridSlam, MapsWithALaserInFrontAndOneBehind) {
  GridSlamOptions options;
  options.particles = 10;
  const RecordedLog log = drive_with({-0.2, 0.1, kPi});
  EXPECT_LT(largest_error(log, run(log, options).trajectory), 0.15);
  EXPECT_GT(largest_error(log, odometry_of(log)), 0.20);
}

}  // namespace
}  // namespace mapbed
