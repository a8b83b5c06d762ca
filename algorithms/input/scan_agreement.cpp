#include "algorithms/input/scan_agreement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/angle.h"
#include "core/geometry/trajectory.h"
#include "core/sensor/laser_scan.h"
#include "core/sensor/odometry.h"

namespace mapbed {
namespace {

constexpr double kTurn = radians(15.0);  // a wrong step shows, odometry is still right to a degree
constexpr double kWay = 0.4;             // [m] likewise for the direction
constexpr double kLongest = 5.0;         // [s] between the two scans
constexpr std::size_t kBeams = 120;      // of the later scan that are looked up
constexpr int kFewestHits = 10;
constexpr int kFewestPairs = 10;
constexpr double kClearErrors = 5.0;    // standard errors
constexpr double kClearFraction = 0.1;  // of the beams
constexpr double kMost = 0.5;           // of the beams

// [m] Odometry's error over such a motion, and a beam's width.
double slack(double range) {
  return 0.1 + 0.03 * range;
}

// At most `most`, evenly.
std::vector<ScanPair> thinned(const std::vector<ScanPair>& pairs, std::size_t most) {
  if (pairs.size() <= most) return pairs;
  std::vector<ScanPair> kept;
  for (std::size_t i = 0; i < most; ++i) kept.push_back(pairs[i * pairs.size() / most]);
  return kept;
}

// Which beam of a scan looks there; -1: none.
std::ptrdiff_t beam_at(const Bearings& bearings, std::size_t beams, double direction) {
  double offset =
      std::fmod((direction - bearings.first) * (bearings.step > 0.0 ? 1.0 : -1.0), 2.0 * kPi);
  const double step = std::abs(bearings.step);
  if (offset < -0.5 * step) offset += 2.0 * kPi;
  const auto beam = static_cast<std::ptrdiff_t>(std::lround(offset / step));
  if (beam < static_cast<std::ptrdiff_t>(beams)) return beam;
  return offset - 2.0 * kPi > -0.5 * step ? 0 : -1;
}

bool see_the_same(double a, double b) {
  return std::abs(a - b) < slack(std::min(a, b));
}

}  // namespace

std::vector<ScanPair> scan_pairs(const SensorLog& log, int laser, std::size_t beams, int most) {
  const Trajectory odometry = odometry_of(log);
  std::vector<ScanPair> turns;
  std::vector<ScanPair> ways;
  const LaserScan* before = nullptr;
  Pose2 pose_before;
  for (const Measurement& m : log) {
    const auto* scan = std::get_if<LaserScan>(&m);
    if (scan == nullptr || scan->laser != laser || scan->ranges.size() != beams) continue;
    const auto pose = pose_at(odometry, scan->time);
    if (!pose) continue;
    const Pose2 motion = before == nullptr ? Pose2{} : inverse(pose_before) * *pose;
    const bool turned = std::abs(motion.theta) >= kTurn;
    const bool moved = std::hypot(motion.x, motion.y) >= kWay;
    const bool late = before != nullptr && scan->time - before->time > kLongest;
    if (before != nullptr && !late && !turned && !moved) continue;
    if (before != nullptr && !late) (turned ? turns : ways).push_back({before, scan, motion});
    before = scan;
    pose_before = *pose;
  }
  const auto half = static_cast<std::size_t>(most / 2);
  const std::size_t left = 2 * half - std::min(half, ways.size());
  std::vector<ScanPair> pairs = thinned(turns, left);
  const std::vector<ScanPair> others = thinned(ways, 2 * half - pairs.size());
  pairs.insert(pairs.end(), others.begin(), others.end());
  return pairs;
}

double agreement(const ScanPair& pair, const Bearings& bearings) {
  const LaserScan& before = *pair.before;
  const LaserScan& after = *pair.after;
  const Pose2 laser_before_from_after = inverse(before.robot_from_laser.planar) *
                                        pair.before_from_after * after.robot_from_laser.planar;
  const std::size_t beams = after.ranges.size();
  const std::size_t stride = std::max<std::size_t>(1, beams / kBeams);
  int in_view = 0;
  int agreeing = 0;
  for (std::size_t beam = 0; beam < beams; beam += stride) {
    if (!after.is_hit(beam)) continue;
    const double bearing = bearings.first + static_cast<double>(beam) * bearings.step;
    const Eigen::Vector2d point =
        laser_before_from_after * Eigen::Vector2d(after.ranges[beam] * std::cos(bearing),
                                                  after.ranges[beam] * std::sin(bearing));
    const std::ptrdiff_t seen = beam_at(bearings, beams, std::atan2(point.y(), point.x()));
    if (seen < 0 || !before.is_hit(static_cast<std::size_t>(seen))) continue;
    ++in_view;
    const double range = point.norm();
    if (std::abs(range - before.ranges[static_cast<std::size_t>(seen)]) < slack(range)) ++agreeing;
  }
  if (in_view < kFewestHits) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(agreeing) / in_view;
}

AgreementComparison compare(const std::vector<ScanPair>& pairs,
                            const std::vector<Bearings>& candidates) {
  AgreementComparison result;
  for (const Bearings& candidate : candidates) {
    std::vector<double> values;
    double sum = 0.0;
    int count = 0;
    for (const ScanPair& pair : pairs) {
      values.push_back(agreement(pair, candidate));
      if (std::isnan(values.back())) continue;
      sum += values.back();
      ++count;
    }
    result.mean.push_back(count == 0 ? 0.0 : sum / count);
    result.pairs.push_back(std::move(values));
  }
  return result;
}

bool is_clearly_better(const AgreementComparison& comparison, std::size_t a, std::size_t b) {
  double sum = 0.0;
  double squares = 0.0;
  double of_a = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < comparison.pairs[a].size(); ++i) {
    const double difference = comparison.pairs[a][i] - comparison.pairs[b][i];
    if (std::isnan(difference)) continue;
    sum += difference;
    squares += difference * difference;
    of_a += comparison.pairs[a][i];
    ++count;
  }
  if (count < kFewestPairs) return false;
  const double mean = sum / count;
  const double variance = std::max(0.0, squares / count - mean * mean) * count / (count - 1);
  return mean >= kClearFraction && mean >= kClearErrors * std::sqrt(variance / count) &&
         of_a / count >= kMost;
}

bool ends_meet(const std::vector<ScanPair>& pairs) {
  int scans = 0;
  int meeting = 0;
  int neighbours = 0;
  for (const ScanPair& pair : pairs) {
    const LaserScan& scan = *pair.before;
    const std::size_t last = scan.ranges.size() - 1;
    const std::size_t middle = last / 2;
    if (last < 3 || !scan.is_hit(0) || !scan.is_hit(last)) continue;
    if (!scan.is_hit(middle) || !scan.is_hit(middle + 1)) continue;
    ++scans;
    meeting += see_the_same(scan.ranges[0], scan.ranges[last]) ? 1 : 0;
    neighbours += see_the_same(scan.ranges[middle], scan.ranges[middle + 1]) ? 1 : 0;
  }
  // Three standard errors of a difference of two fractions, at most 1/2 each.
  return meeting + 3.0 * std::sqrt(0.5 * scans) >= neighbours;
}

}  // namespace mapbed
