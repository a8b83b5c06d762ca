#include "bench/faults/skewed_sweeps.h"

#include <algorithm>
#include <cmath>

#include "bench/faults/fault_instants.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

// The number of the beam that is nearest to a bearing; -1: the scan did not look there.
int beam_at(const LaserScan& scan, double bearing) {
  const int beams = static_cast<int>(scan.ranges.size());
  double since_first = bearing - scan.first_bearing;
  const double around = 2.0 * kPi;
  const bool is_full_circle = (beams + 0.5) * std::abs(scan.bearing_step) > around;
  if (is_full_circle) {
    const double turns = std::floor(since_first / std::copysign(around, scan.bearing_step));
    since_first -= turns * std::copysign(around, scan.bearing_step);
  }
  const int beam = static_cast<int>(std::lround(since_first / scan.bearing_step));
  if (is_full_circle) return beam % beams;
  return beam >= 0 && beam < beams ? beam : -1;
}

// What a beam reads when the laser has moved since the scan's stamp.
double moved_reading(const LaserScan& scan, std::size_t beam, const Pose2& laser_from_moved) {
  const double bearing = scan.bearing(beam) + laser_from_moved.theta;
  const int nearest = beam_at(scan, bearing);
  if (nearest < 0) return 0.0;
  const auto seen = static_cast<std::size_t>(nearest);
  if (!scan.is_hit(seen)) return scan.ranges[seen];
  const double nearer =
      laser_from_moved.x * std::cos(bearing) + laser_from_moved.y * std::sin(bearing);
  return std::clamp(scan.ranges[seen] - nearer, 0.0, std::nextafter(scan.max_range, 0.0));
}

void skew(LaserScan& scan, const Trajectory& path, double duration) {
  const std::size_t beams = scan.ranges.size();
  const auto at_first = pose_at(path, scan.time);
  const auto at_last = pose_at(path, scan.time + duration);
  if (beams < 2 || !at_first || !at_last || scan.bearing_step == 0.0) return;
  const Pose2& robot_from_laser = scan.robot_from_laser.planar;
  const LaserScan given = scan;
  for (std::size_t beam = 0; beam < beams; ++beam) {
    const double fraction = static_cast<double>(beam) / static_cast<double>(beams - 1);
    const auto here = pose_at(path, scan.time + fraction * duration);
    const Pose2 laser_from_moved =
        inverse(robot_from_laser) * motion_between(*at_first, *here) * robot_from_laser;
    scan.ranges[beam] = moved_reading(given, beam, laser_from_moved);
  }
}

}  // namespace

BrokenLog with_skewed_sweeps(SensorLog log, const Trajectory& truth,
                             const SkewedSweepsOptions& options) {
  if (options.duration <= 0.0 || log.empty()) return {std::move(log)};
  const Trajectory path = truth.empty() ? odometry_of(log) : truth;
  for (Measurement& measurement : log) {
    if (auto* scan = std::get_if<LaserScan>(&measurement)) skew(*scan, path, options.duration);
  }
  const TimeInterval whole = whole_of(log);
  return {std::move(log), {whole}};
}

}  // namespace mapbed
