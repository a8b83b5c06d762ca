#include "algorithms/input/repeated_scans.h"

#include <cmath>

#include <fmt/format.h>

namespace mapbed {
namespace {

bool sees_anything(const LaserScan& scan) {
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    if (scan.is_hit(beam)) return true;
  }
  return false;
}

}  // namespace

LaserScan RepeatedScans::checked(LaserScan scan) {
  Newest& newest = newest_[scan.laser];
  if (scan.ranges != newest.ranges) {
    newest.ranges = scan.ranges;
    newest.odometry = odometry_;
    newest.repeated.tell(scan.time, false);
    return scan;
  }
  if (!newest.odometry || !odometry_ || !sees_anything(scan)) return scan;
  const Pose2 motion = motion_between(*newest.odometry, *odometry_);
  const bool moved =
      std::hypot(motion.x, motion.y) > options_.distance || std::abs(motion.theta) > options_.turn;
  newest.repeated.tell(scan.time, moved);
  if (moved) {
    scan.ranges.clear();
    scan.remissions.clear();
  }
  return scan;
}

std::vector<Remark> RepeatedScans::remarks(double start) const {
  std::vector<Remark> result;
  for (const auto& [laser, newest] : newest_) {
    const std::string what = fmt::format("laser {} tells the same scan again", laser);
    for (Remark& remark : remarks_on(newest.repeated, RemarkKind::repeated_scan, start, what,
                                     ": no measurement, odometry alone says how the robot moves")) {
      result.push_back(std::move(remark));
    }
  }
  return result;
}

}  // namespace mapbed
