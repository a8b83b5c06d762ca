#include "algorithms/input/sweep_correction.h"

#include <algorithm>
#include <cmath>

namespace mapbed {
namespace {

// Less than lasers and mounts are off: scans stay as they are.
constexpr double kLeastTurn = 0.01;  // [rad]
constexpr double kLeastWay = 0.01;   // [m]
constexpr double kLongestGap = 0.5;  // [s] between readings, over which the motion is not known

bool is_known(const Trajectory& odometry, double from, double to) {
  if (odometry.empty() || odometry.front().time > from || odometry.back().time < to) return false;
  const auto is_before = [](const Stamped<Pose2>& reading, double time) {
    return reading.time < time;
  };
  auto next = std::upper_bound(
      odometry.begin(), odometry.end(), from,
      [](double time, const Stamped<Pose2>& reading) { return time < reading.time; });
  const auto end = std::lower_bound(next, odometry.end(), to, is_before);
  for (; next != odometry.end() && next <= end; ++next) {
    if (next != odometry.begin() && next->time - (next - 1)->time > kLongestGap) return false;
  }
  return true;
}

}  // namespace

double sweep_duration(const LaserScan& scan) {
  if (scan.ranges.empty()) return 0.0;
  return std::abs(scan.beam_period) * static_cast<double>(scan.ranges.size() - 1);
}

LaserScan with_corrected_sweep(LaserScan scan, const Trajectory& odometry) {
  const double duration = sweep_duration(scan);
  if (duration == 0.0 || !scan.robot_from_beams.empty()) return scan;
  if (!is_known(odometry, scan.time, scan.time + duration)) return scan;
  const Pose2 at_stamp = *pose_at(odometry, scan.time);
  const Pose2 whole = motion_between(at_stamp, *pose_at(odometry, scan.time + duration));
  if (std::abs(whole.theta) < kLeastTurn && std::hypot(whole.x, whole.y) < kLeastWay) return scan;
  const std::size_t beams = scan.ranges.size();
  scan.robot_from_beams.reserve(beams);
  for (std::size_t beam = 0; beam < beams; ++beam) {
    const std::size_t place = scan.beam_period > 0.0 ? beam : beams - 1 - beam;
    const double time = scan.time + static_cast<double>(place) * std::abs(scan.beam_period);
    const Pose2 moved =
        motion_between(at_stamp, *pose_at(odometry, std::min(time, scan.time + duration)));
    scan.robot_from_beams.push_back(moved * scan.robot_from_laser.planar *
                                    Pose2{0.0, 0.0, scan.bearing(beam)});
  }
  return scan;
}

}  // namespace mapbed
