#include "bench/faults/odometry_steps.h"

namespace mapbed {

SensorLog with_steps(SensorLog log, const std::function<Pose2(const OdometryStep&)>& told) {
  bool is_first = true;
  bool is_changed = false;
  Odometry before;    // as it was
  Pose2 told_before;  // as it is told now
  for (Measurement& measurement : log) {
    auto* reading = std::get_if<Odometry>(&measurement);
    if (reading == nullptr) continue;
    const Odometry given = *reading;
    if (!is_first) {
      const Pose2 motion = motion_between(before.odometry_from_robot, given.odometry_from_robot);
      const Pose2 told_motion = told({before.time, given.time, motion});
      is_changed = is_changed || !(told_motion == motion);
      if (is_changed) reading->odometry_from_robot = told_before * told_motion;
    }
    told_before = reading->odometry_from_robot;
    before = given;
    is_first = false;
  }
  return log;
}

}  // namespace mapbed
