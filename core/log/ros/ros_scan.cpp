#include "core/log/ros/ros_scan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/angle.h"
#include "core/log/laser_geometry.h"
#include "core/log/ros/unrounded.h"

namespace mapbed {
namespace {

constexpr double kLongestSweep = 1.0;  // [s]

// [s] 0 where it cannot be meant.
double beam_period_of(const RosLaserScan& message, std::string& remark) {
  const double period = message.time_increment;
  if (period == 0.0) return 0.0;
  const double sweep = std::abs(period) * static_cast<double>(message.ranges.size());
  const bool fits_scan_time = !(message.scan_time > 0.0) || sweep <= 1.1 * message.scan_time;
  if (std::isfinite(period) && sweep <= kLongestSweep && fits_scan_time) return period;
  remark = "time_increment does not fit scan_time: beams taken as of one moment";
  return 0.0;
}

double clean_range(double range, double range_min) {
  const bool is_none = std::isnan(range) || range < range_min || range < 0.0;
  return is_none && range != 0.0 ? kNoReading : range;
}

// [m] Mounts that come by sines and cosines are off in their last digits.
double rounded(double value) {
  return std::round(value * 1e9) / 1e9 + 0.0;
}

}  // namespace

ConvertedScan converted(RosLaserScan&& message) {
  ConvertedScan result;
  LaserScan& scan = result.scan;
  scan.time = message.header.stamp;
  for (const double angle : {message.angle_min, message.angle_max, message.angle_increment})
    if (!std::isfinite(angle)) return result;
  scan.first_bearing = message.angle_min;
  scan.bearing_step = message.angle_increment;
  result.field_of_view = message.angle_max - message.angle_min;
  scan.beam_period = beam_period_of(message, result.remark);
  const bool has_max = message.range_max > 0.0 && message.range_max <= kAbsurdRange;
  scan.max_range = has_max ? message.range_max : 0.0;
  const double range_min = message.range_min > 0.0 ? message.range_min : 0.0;
  scan.ranges = std::move(message.ranges);
  for (double& range : scan.ranges) range = clean_range(range, range_min);
  if (message.intensities.size() == scan.ranges.size())
    scan.remissions = std::move(message.intensities);
  return result;
}

void set_mount(LaserScan& scan, const Pose3& robot_from_laser) {
  Eigen::Matrix3d axes = robot_from_laser.rotation.toRotationMatrix();
  if (axes(2, 2) < 0.0) {
    axes.col(1) *= -1.0;
    axes.col(2) *= -1.0;
    scan.first_bearing *= -1.0;
    scan.bearing_step *= -1.0;
  }
  Mount& mount = scan.robot_from_laser;
  mount.planar.x = rounded(robot_from_laser.position.x());
  mount.planar.y = rounded(robot_from_laser.position.y());
  mount.z = rounded(robot_from_laser.position.z());
  mount.planar.theta = normalized_angle(unrounded_mount_angle(std::atan2(axes(1, 0), axes(0, 0))));
  mount.pitch = unrounded_mount_angle(std::asin(std::clamp(-axes(2, 0), -1.0, 1.0)));
  mount.roll = unrounded_mount_angle(std::atan2(axes(2, 1), axes(2, 2)));
}

}  // namespace mapbed
