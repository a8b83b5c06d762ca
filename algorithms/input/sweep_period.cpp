#include "algorithms/input/sweep_period.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

#include <fmt/format.h>

#include "algorithms/input/scan_consistency.h"
#include "algorithms/input/sweep_correction.h"
#include "algorithms/scan/hit_points.h"
#include "core/geometry/angle.h"
#include "core/statistics/quantile.h"

namespace mapbed {
namespace {

constexpr double kShortest = 0.02, kLongest = 0.5;  // [s] of a turn of the mirror
constexpr double kLeastSkew = 0.05;  // [rad] by which two scans are distorted against each other
constexpr double kNear = 1.0;        // [s] between them: odometry is good for so long
constexpr std::size_t kLeastPairs = 10;
constexpr std::size_t kMostPairs = 60;
constexpr double kClearlyBetter = 0.75;  // of the mismatch without
constexpr double kMostOfThem = 0.8;      // of the pairs that fit better
constexpr HitPointOptions kPoints{.max_range = 15.0, .min_spacing = 0.0, .max_points = 360};

struct Pair {
  const LaserScan* a = nullptr;
  const LaserScan* b = nullptr;
  double skew = 0.0;  // [rad]
};

// [s] from scan to scan.
double usual_interval(const std::vector<const LaserScan*>& scans) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < scans.size(); ++i) {
    intervals.push_back(scans[i]->time - scans[i - 1]->time);
  }
  return median_of(std::move(intervals));
}

// [rad] the turn of the robot in the `duration` [s] after a stamp.
double turn_during(const Trajectory& odometry, double time, double duration) {
  const auto from = pose_at(odometry, time), to = pose_at(odometry, time + duration);
  return from && to ? motion_between(*from, *to).theta : 0.0;
}

// Those that differ most in how the robot turned while they were taken.
std::vector<Pair> telling_pairs(const std::vector<const LaserScan*>& scans,
                                const Trajectory& odometry, double duration) {
  std::vector<double> turns;
  for (const LaserScan* scan : scans) {
    turns.push_back(turn_during(odometry, scan->time, duration));
  }
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < scans.size(); ++a) {
    Pair best;
    for (std::size_t b = a + 1; b < scans.size() && scans[b]->time - scans[a]->time < kNear; ++b) {
      const double skew = std::abs(turns[b] - turns[a]);
      if (skew > std::max(kLeastSkew, best.skew)) best = {scans[a], scans[b], skew};
    }
    if (best.a != nullptr) pairs.push_back(best);
  }
  if (pairs.size() > kMostPairs) {
    std::nth_element(pairs.begin(), pairs.begin() + kMostPairs, pairs.end(),
                     [](const Pair& p, const Pair& q) { return p.skew > q.skew; });
    pairs.resize(kMostPairs);
  }
  return pairs;
}

double mismatch_of(const Pair& pair, const Trajectory& odometry, double beam_period) {
  const auto points = [&](LaserScan scan) {
    scan.beam_period = beam_period;
    return hit_points(with_corrected_sweep(std::move(scan), odometry), kPoints);
  };
  const auto a = pose_at(odometry, pair.a->time), b = pose_at(odometry, pair.b->time);
  return mismatch(points(*pair.a), points(*pair.b), motion_between(*a, *b));
}

std::vector<double> mismatches_of(const std::vector<Pair>& pairs, const Trajectory& odometry,
                                  double beam_period) {
  std::vector<double> result;
  for (const Pair& pair : pairs) result.push_back(mismatch_of(pair, odometry, beam_period));
  return result;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

// Zero where nothing else is clearly better.
FoundPeriod period_of(const std::vector<const LaserScan*>& scans, const Trajectory& odometry) {
  if (scans.size() < 2 || odometry.empty()) return {};
  const double interval = usual_interval(scans);
  if (interval < kShortest || interval > kLongest) return {};
  const double period = interval * std::abs(scans.front()->bearing_step) / (2.0 * kPi);
  const double duration = period * static_cast<double>(scans.front()->ranges.size());
  const std::vector<Pair> pairs = telling_pairs(scans, odometry, duration);
  if (pairs.size() < kLeastPairs) return {};
  const std::vector<double> without = mismatches_of(pairs, odometry, 0.0);
  FoundPeriod best{
      .beam_period = 0.0, .mismatch = mean_of(without), .mismatch_before = mean_of(without)};
  for (const double candidate : {period, -period}) {
    const std::vector<double> with = mismatches_of(pairs, odometry, candidate);
    std::size_t better = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) better += with[i] < without[i] ? 1 : 0;
    const double needed = kMostOfThem * static_cast<double>(pairs.size());
    const bool fits_better = mean_of(with) < (kClearlyBetter * best.mismatch_before);
    const bool is_clear = fits_better && static_cast<double>(better) > needed;
    if (is_clear && mean_of(with) < best.mismatch) {
      best.beam_period = candidate;
      best.mismatch = mean_of(with);
    }
  }
  return best;
}

}  // namespace

std::map<int, FoundPeriod> found_periods(const SensorLog& log) {
  std::map<int, std::vector<const LaserScan*>> lasers;
  for (const Measurement& measurement : log) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr || scan->beam_period != 0.0 || scan->ranges.size() < 2) continue;
    lasers[scan->laser].push_back(scan);
  }
  const Trajectory odometry = odometry_of(log);
  std::map<int, FoundPeriod> result;
  for (const auto& [laser, scans] : lasers) {
    const FoundPeriod found = period_of(scans, odometry);
    if (found.beam_period != 0.0) result[laser] = found;
  }
  return result;
}

std::vector<Remark> remarks_on(const std::map<int, FoundPeriod>& periods) {
  std::vector<Remark> result;
  for (const auto& [laser, found] : periods) {
    result.push_back(
        {RemarkKind::skewed_sweep,
         fmt::format("laser {} takes its beams one after the other: with {:.4g} ms from beam to "
                     "beam, scans about turns lie {:.1f} cm from each other, not {:.1f} cm; state "
                     "it with input.sweep.beam_period",
                     laser, 1e3 * found.beam_period, 1e2 * found.mismatch,
                     1e2 * found.mismatch_before)});
  }
  return result;
}

}  // namespace mapbed
