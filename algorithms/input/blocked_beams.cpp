#include "algorithms/input/blocked_beams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "core/geometry/angle.h"
#include "core/geometry/trajectory.h"
#include "core/statistics/quantile.h"

namespace mapbed {
namespace {

constexpr std::size_t kDirections = 8;   // of the robot's heading
constexpr std::size_t kLooked = 6;       // of these that it must have looked into
constexpr std::size_t kFewestScans = 3;  // into a direction
constexpr std::size_t kMostScans = 25;   // that are compared, evenly over the log
constexpr double kOdd = 0.1;             // of these, at either end, that may read anything
constexpr double kSame = 0.1;            // [m] between the readings of dirt and of stuck beams
constexpr double kFar = 0.9;             // of the maximum range: no return, and what is near it
constexpr double kApart = 0.1;           // [m], [rad] between scans that count

using Scans = std::vector<const LaserScan*>;
using ByDirection = std::array<Scans, kDirections>;

std::size_t direction_of(const Pose2& pose) {
  const double turns = (normalized_angle(pose.theta) + kPi) / (2.0 * kPi);
  return std::min(kDirections - 1, static_cast<std::size_t>(turns * kDirections));
}

// The scans of each laser that are as its first one, by the robot's heading, while it moves.
std::map<int, ByDirection> looks(const SensorLog& log) {
  struct Last {
    const LaserScan* scan = nullptr;
    Pose2 pose;
  };
  const Trajectory odometry = odometry_of(log);
  std::map<int, ByDirection> lasers;
  std::map<int, Last> last;
  for (const Measurement& measurement : log) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr) continue;
    const auto pose = pose_at(odometry, scan->time);
    if (!pose) continue;
    Last& before = last[scan->laser];
    if (before.scan != nullptr) {
      if (scan->ranges.size() != before.scan->ranges.size()) continue;
      const Pose2 motion = motion_between(before.pose, *pose);
      const bool moved = std::hypot(motion.x, motion.y) >= kApart;
      if (!moved && std::abs(motion.theta) < kApart) continue;
    }
    before = {scan, *pose};
    lasers[scan->laser][direction_of(*pose)].push_back(scan);
  }
  return lasers;
}

Scans thinned(const Scans& scans) {
  if (scans.size() <= kMostScans) return scans;
  Scans kept;
  for (std::size_t i = 0; i < kMostScans; ++i) kept.push_back(scans[i * scans.size() / kMostScans]);
  return kept;
}

// What a beam reads in nearly all scans into all directions [m].
struct Readings {
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = 0.0;

  void add(const Scans& scans, std::size_t beam) {
    std::vector<double> ranges;
    for (const LaserScan* scan : scans) ranges.push_back(scan->ranges[beam]);
    nearest = std::min(nearest, quantile_of(ranges, kOdd));
    farthest = std::max(farthest, quantile_of(ranges, 1.0 - kOdd));
  }
  bool are_same(double max_range) const {
    return nearest > 0.0 && farthest < kFar * max_range && farthest - nearest <= kSame;
  }
};

std::optional<BlockedBeams> blocked_of(const ByDirection& directions) {
  std::vector<Scans> looked;
  for (const Scans& scans : directions) {
    if (scans.size() >= kFewestScans) looked.push_back(thinned(scans));
  }
  if (looked.size() < kLooked) return {};
  const LaserScan& scan = *looked.front().front();
  BlockedBeams blocked{.is_blocked = std::vector<bool>(scan.ranges.size()),
                       .nearest = std::numeric_limits<double>::infinity()};
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    Readings readings;
    for (const Scans& scans : looked) readings.add(scans, beam);
    if (!readings.are_same(scan.max_range)) continue;
    blocked.is_blocked[beam] = true;
    blocked.nearest = std::min(blocked.nearest, readings.nearest);
    blocked.farthest = std::max(blocked.farthest, readings.farthest);
  }
  const std::size_t count = blocked.count();
  if (count == 0 || 2 * count > scan.ranges.size()) return {};
  return blocked;
}

}  // namespace

std::size_t BlockedBeams::count() const {
  return static_cast<std::size_t>(std::count(is_blocked.begin(), is_blocked.end(), true));
}

std::map<int, BlockedBeams> blocked_beams(const SensorLog& log) {
  std::map<int, BlockedBeams> all;
  for (const auto& [laser, directions] : looks(log)) {
    if (auto blocked = blocked_of(directions)) all[laser] = std::move(*blocked);
  }
  return all;
}

LaserScan without_blocked(LaserScan scan, const std::map<int, BlockedBeams>& blocked) {
  const auto found = blocked.find(scan.laser);
  if (found == blocked.end() || found->second.is_blocked.size() != scan.ranges.size()) return scan;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    if (found->second.is_blocked[beam]) scan.ranges[beam] = 0.0;
  }
  return scan;
}

std::vector<Remark> remarks_on(const std::map<int, BlockedBeams>& blocked) {
  std::vector<Remark> result;
  for (const auto& [laser, beams] : blocked) {
    result.push_back(
        {RemarkKind::blocked_beams,
         fmt::format("{} of the {} beams of laser {} read the same whatever way the robot looks, "
                     "{:.2f} m to {:.2f} m: dirt, or a part of the robot; they are left out",
                     beams.count(), beams.is_blocked.size(), laser, beams.nearest,
                     beams.farthest)});
  }
  return result;
}

}  // namespace mapbed
