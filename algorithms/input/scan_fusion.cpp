#include "algorithms/input/scan_fusion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/check.h"

namespace mapbed {
namespace {

// How the robot moved between two stamps; not at all where nobody knows.
Pose2 motion_over(const Trajectory& odometry, double from, double to) {
  if (from == to || odometry.empty()) return {};
  const auto a = pose_at(odometry, from), b = pose_at(odometry, to);
  return a && b ? motion_between(*a, *b) : Pose2{};
}

void append(const LaserScan& scan, const Pose2& moved, LaserScan& whole) {
  const bool has_own_places = !scan.robot_from_beams.empty();
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const Pose2 robot_from_beam =
        has_own_places ? scan.robot_from_beams[beam]
                       : scan.robot_from_laser.planar * Pose2{0.0, 0.0, scan.bearing(beam)};
    whole.robot_from_beams.push_back(moved == Pose2{} ? robot_from_beam : moved * robot_from_beam);
    const bool ends_nowhere = scan.is_max_range(beam) && scan.max_range < whole.max_range;
    whole.ranges.push_back(ends_nowhere ? 0.0 : scan.ranges[beam]);
  }
}

}  // namespace

bool are_of_one_instant(const LaserScan& a, const LaserScan& b, const ScanFusionOptions& options) {
  return a.laser != b.laser && std::abs(b.time - a.time) <= options.within &&
         a.robot_from_laser.is_level() && b.robot_from_laser.is_level();
}

LaserScan fused(std::vector<LaserScan> scans, const Trajectory& odometry) {
  CHECK(!scans.empty());
  if (scans.size() == 1) return std::move(scans.front());
  LaserScan whole = scans.front();
  whole.ranges.clear();
  whole.robot_from_beams.clear();
  whole.remissions.clear();
  for (const LaserScan& scan : scans) {
    whole.max_range = std::max(whole.max_range, scan.max_range);
    if (std::abs(scan.bearing_step) > std::abs(whole.bearing_step)) {
      whole.bearing_step = scan.bearing_step;
    }
  }
  for (const LaserScan& scan : scans) {
    append(scan, motion_over(odometry, whole.time, scan.time), whole);
    whole.parts.push_back({scan.time, scan.laser, scan.ranges.size()});
  }
  const bool all_remit = std::all_of(scans.begin(), scans.end(), [](const LaserScan& scan) {
    return scan.remissions.size() == scan.ranges.size();
  });
  if (!all_remit) return whole;
  for (const LaserScan& scan : scans) {
    whole.remissions.insert(whole.remissions.end(), scan.remissions.begin(), scan.remissions.end());
  }
  return whole;
}

}  // namespace mapbed
