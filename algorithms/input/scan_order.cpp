#include "algorithms/input/scan_order.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "algorithms/input/time_intervals.h"
#include "core/geometry/angle.h"
#include "core/geometry/trajectory.h"

namespace mapbed {
namespace {

constexpr double kReach = 0.5;           // [m] what is further off says no more
constexpr std::size_t kBeams = 90;       // of a scan that are looked up
constexpr int kFewestHits = 20;          // of these
constexpr double kOneSurface = 0.1;      // of the range, between neighbouring beams
constexpr double kOdd = 0.05;            // [m] beyond what beams and odometry err
constexpr double kClearFraction = 0.35;  // of the misfit is left in the other order, at most
constexpr double kFraction = 0.75;       // the same where other scans are known to be swapped
constexpr std::size_t kKnown = 3;        // so many of these
constexpr double kClearDistance = 0.04;  // [m] by which it is less, at least

// A scan, and where odometry has the robot at the stamp that it is taken to have.
struct PlacedScan {
  std::size_t number = 0;  // in the log
  const LaserScan* scan = nullptr;
  Pose2 odometry_from_robot;
};

using Directions = std::vector<Eigen::Vector2d>;  // of beams, in the laser's frame

Directions directions_of(const LaserScan& scan) {
  Directions directions;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const double bearing = scan.bearing(beam);
    directions.emplace_back(std::cos(bearing), std::sin(bearing));
  }
  return directions;
}

bool are_alike(const LaserScan& a, const LaserScan& b) {
  return a.ranges.size() == b.ranges.size() && a.first_bearing == b.first_bearing &&
         a.bearing_step == b.bearing_step;
}

// [m] What a scan reads in a direction, between two beams on one surface; not a number else.
double range_at(const LaserScan& scan, double direction) {
  const double sign = scan.bearing_step > 0.0 ? 1.0 : -1.0;
  double offset = std::fmod((direction - scan.first_bearing) * sign, 2.0 * kPi);
  if (offset < 0.0) offset += 2.0 * kPi;
  const double place = offset / std::abs(scan.bearing_step);
  const auto beam = static_cast<std::size_t>(place);
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (beam + 1 >= scan.ranges.size() || !scan.is_hit(beam) || !scan.is_hit(beam + 1)) return kNone;
  const double a = scan.ranges[beam], b = scan.ranges[beam + 1];
  if (std::abs(a - b) > kOneSurface * std::min(a, b)) return kNone;
  return a + (place - static_cast<double>(beam)) * (b - a);
}

// [m] How far hits of `after` lie from what `before` saw in their directions, in the mean; not a
// number where too few are in its view.
double misfit(const Directions& directions, const LaserScan& before, const Pose2& odometry_before,
              const LaserScan& after, const Pose2& odometry_after) {
  const Pose2 before_from_after = inverse(odometry_before * before.robot_from_laser.planar) *
                                  (odometry_after * after.robot_from_laser.planar);
  const std::size_t stride = std::max<std::size_t>(1, after.ranges.size() / kBeams);
  double sum = 0.0;
  int hits = 0;
  for (std::size_t beam = 0; beam < after.ranges.size(); beam += stride) {
    if (!after.is_hit(beam)) continue;
    const Eigen::Vector2d point = before_from_after * (after.ranges[beam] * directions[beam]);
    const double seen = range_at(before, std::atan2(point.y(), point.x()));
    if (std::isnan(seen)) continue;
    sum += std::min(kReach, std::abs(point.norm() - seen));
    ++hits;
  }
  return hits < kFewestHits ? std::numeric_limits<double>::quiet_NaN() : sum / hits;
}

// The scans of one laser that are alike and taken where odometry knows the robot.
std::vector<std::vector<PlacedScan>> placed_scans(const SensorLog& log) {
  const Trajectory odometry = odometry_of(log);
  std::map<int, std::vector<PlacedScan>> lasers;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const auto* scan = std::get_if<LaserScan>(&log[i]);
    if (scan == nullptr || scan->bearing_step == 0.0) continue;
    std::vector<PlacedScan>& placed = lasers[scan->laser];
    if (!placed.empty() && !are_alike(*placed.front().scan, *scan)) continue;
    const auto pose = pose_at(odometry, scan->time);
    if (pose) placed.push_back({i, scan, *pose});
  }
  std::vector<std::vector<PlacedScan>> all;
  for (auto& [laser, placed] : lasers) {
    if (!placed.empty()) all.push_back(std::move(placed));
  }
  return all;
}

// How badly four scans in a row fit on each other in the order of their stamps, and with the middle
// two exchanged [m].
struct Orders {
  double stated = 0.0, exchanged = 0.0;

  bool are_clear(double fraction) const {
    return exchanged < fraction * stated && exchanged < stated - kClearDistance;
  }
};

class Neighbours {
 public:
  explicit Neighbours(std::vector<PlacedScan> scans)
      : scans_(std::move(scans)), directions_(directions_of(*scans_.front().scan)) {
    for (std::size_t i = 0; i + 1 < scans_.size(); ++i)
      steps_.push_back(between(i, i, i + 1, i + 1));
  }

  // Of the scan after `before` and the next one.
  bool are_swapped(std::size_t before, double fraction) const {
    const std::size_t a = before + 1, b = before + 2, after = before + 3;
    const double stated = (steps_[before] + steps_[a] + steps_[b]) / 3.0;
    if (!(stated > kOdd)) return false;
    const double exchanged =
        (between(before, before, b, a) + between(b, a, a, b) + between(a, b, after, after)) / 3.0;
    return Orders{stated, exchanged}.are_clear(fraction);
  }

  SwappedScans exchange(std::size_t a, std::size_t b) {
    const SwappedScans swapped{
        scans_[a].number, scans_[b].number, {scans_[a].scan->time, scans_[b].scan->time}};
    std::swap(scans_[a].scan, scans_[b].scan);
    for (std::size_t i = a - 1; i <= b; ++i) steps_[i] = between(i, i, i + 1, i + 1);
    return swapped;
  }

  std::size_t size() const { return scans_.size(); }

 private:
  // Of the contents of scans at the places of others.
  double between(std::size_t first, std::size_t first_place, std::size_t second,
                 std::size_t second_place) const {
    return misfit(directions_, *scans_[first].scan, scans_[first_place].odometry_from_robot,
                  *scans_[second].scan, scans_[second_place].odometry_from_robot);
  }

  std::vector<PlacedScan> scans_;
  Directions directions_;
  std::vector<double> steps_;  // [m] misfit from each scan to the next
};

// Those that are clear are put in order.
std::vector<SwappedScans> exchanged(Neighbours& neighbours, double fraction) {
  std::vector<SwappedScans> swapped;
  for (std::size_t before = 0; before + 3 < neighbours.size(); ++before) {
    if (!neighbours.are_swapped(before, fraction)) continue;
    swapped.push_back(neighbours.exchange(before + 1, before + 2));
  }
  return swapped;
}

}  // namespace

std::vector<SwappedScans> swapped_scans(const SensorLog& log) {
  std::vector<SwappedScans> swapped;
  for (std::vector<PlacedScan>& scans : placed_scans(log)) {
    Neighbours neighbours(std::move(scans));
    std::vector<SwappedScans> found = exchanged(neighbours, kClearFraction);
    if (found.size() >= kKnown) {
      const std::vector<SwappedScans> more = exchanged(neighbours, kFraction);
      found.insert(found.end(), more.begin(), more.end());
    }
    swapped.insert(swapped.end(), found.begin(), found.end());
  }
  std::sort(swapped.begin(), swapped.end(),
            [](const auto& a, const auto& b) { return a.when.from < b.when.from; });
  return swapped;
}

SensorLog in_order(SensorLog log, const std::vector<SwappedScans>& swapped) {
  for (const SwappedScans& pair : swapped) {
    auto& first = std::get<LaserScan>(log[pair.first]);
    auto& second = std::get<LaserScan>(log[pair.second]);
    std::swap(first, second);
    std::swap(first.time, second.time);
  }
  return log;
}

std::vector<Remark> remarks_on(const std::vector<SwappedScans>& swapped, double start) {
  TimeIntervals times;
  for (const SwappedScans& pair : swapped) {
    times.tell(pair.when.from, true);
    times.tell(pair.when.to, true);
    times.tell(pair.when.to, false);
  }
  return remarks_on(times, RemarkKind::stamp_order, start,
                    "neighbouring scans have each other's stamps",
                    ": put where they fit on those about them");
}

}  // namespace mapbed
