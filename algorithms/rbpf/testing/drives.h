#pragma once

#include <cstdint>
#include <utility>
#include <variant>

#include "algorithms/input/input_stage.h"
#include "algorithms/rbpf/grid_slam.h"
#include "algorithms/testing/furnished_room.h"
#include "core/testing/test_room.h"

// Logs of drives for the tests of the particle filter, and what it makes of them, prepared.

namespace mapbed {

// Twice round a corridor, whose four sides differ by a box each.
inline RecordedLog two_rounds() {
  DriveOptions drive;
  drive.laser.max_range = 15.0;
  TestRoom room = ring_corridor();
  room.add_box({3.0, -4.3}, 0.4, 0.3);
  room.add_box({4.4, 2.0}, 0.3, 0.5);
  room.add_box({-1.0, 4.4}, 0.6, 0.3);
  room.add_box({-4.4, -1.0}, 0.3, 0.6);
  return drive_through(room, {{-5, -5}, {5, -5}, {5, 5}, {-5, 5}, {-5, -5}, {5, -5}}, drive,
                       Rng(4));
}

// As where the robot's counters were set back.
inline RecordedLog with_jump_of_odometry(RecordedLog log, double since) {
  for (Measurement& measurement : log.measurements) {
    auto* odometry = std::get_if<Odometry>(&measurement);
    if (odometry == nullptr || odometry->time < since) continue;
    odometry->odometry_from_robot = Pose2{5.0, -3.0, 1.0} * odometry->odometry_from_robot;
  }
  return log;
}

inline RecordedLog without_odometry(RecordedLog log) {
  std::erase_if(log.measurements,
                [](const Measurement& m) { return std::holds_alternative<Odometry>(m); });
  return log;
}

inline GridSlam filter_after(const RecordedLog& log, const GridSlamOptions& options) {
  GridSlam slam(options, Rng(1));
  for (const Measurement& measurement : log.measurements) slam.add(measurement);
  return slam;
}

inline Estimate run(const RecordedLog& log, const GridSlamOptions& options) {
  PreparedLog prepared = mapbed::prepared(log.measurements);
  GridSlam slam(options, Rng(1));
  for (const Measurement& measurement : prepared.log) slam.add(measurement);
  Estimate estimate = slam.estimate();
  for (Remark& remark : prepared.remarks) estimate.remarks.push_back(std::move(remark));
  return estimate;
}

// Of the last pose, both paths beginning at the same one [m].
inline double error_at_end(const RecordedLog& log, const Estimate& estimate) {
  const Pose2 first = *pose_at(log.true_poses, estimate.trajectory.front().time);
  const Pose2 last = *pose_at(log.true_poses, estimate.trajectory.back().time);
  return distance(motion_between(first, last), estimate.trajectory.back().pose);
}

}  // namespace mapbed
