#include "algorithms/input/odometry_lag.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "algorithms/input/told_odometry.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr double kLongestLag = 0.6;  // [s]
constexpr double kLagStep = 0.01;    // [s]
// [s] That is told. Right stamps seemed 0.06 s early on one of 200 simulated drives, in corridors
// with few bends; why is not known.
constexpr double kLeastLag = 0.08;
constexpr double kLongestStep = 1.2;     // [s] between two scans
constexpr double kShortestWay = 0.15;    // [m] up to which a robot turns on the spot
constexpr double kTurns = 0.05;          // [rad] from scan to scan, at least
constexpr double kLargestTurn = 0.6;     // [rad]
constexpr std::size_t kMostPairs = 400;  // spread over the log
constexpr std::size_t kFewestPairs = 30;

// Two scans of one laser, the second after the first.
struct Pair {
  const LaserScan* first = nullptr;
  const LaserScan* second = nullptr;
};

// How the ranges differ where the second scan is taken to be turned by so many beams.
double difference(const Pair& pair, int beams) {
  constexpr double kLargest = 0.5;  // [m] what was not there before differs by any amount
  const auto count = static_cast<int>(pair.first->ranges.size());
  double sum = 0.0;
  int compared = 0;
  for (int i = std::max(0, -beams); i < count - std::max(0, beams); i += 2) {
    const auto first = static_cast<std::size_t>(i + beams), second = static_cast<std::size_t>(i);
    if (!pair.first->is_hit(first) || !pair.second->is_hit(second)) continue;
    sum += std::min(kLargest, std::abs(pair.first->ranges[first] - pair.second->ranges[second]));
    ++compared;
  }
  return compared >= count / 8 ? sum / compared : kLargest;
}

// [rad] by which the robot turned from one scan to the other; none where the ranges do not tell.
std::optional<double> turn_between(const Pair& pair) {
  const double step = pair.first->bearing_step;
  const int most = static_cast<int>(kLargestTurn / std::abs(step));
  std::vector<double> values;
  for (int beams = -most; beams <= most; ++beams) values.push_back(difference(pair, beams));
  const auto least = std::min_element(values.begin(), values.end());
  const std::size_t index = static_cast<std::size_t>(least - values.begin());
  constexpr double kFits = 0.15;  // [m]
  if (*least > kFits || index == 0 || index + 1 == values.size()) return {};
  // Between the beams: where a parabola through the three values about it is least.
  const double before = values[index - 1], after = values[index + 1];
  const double bend = before - 2.0 * *least + after;
  const double between = bend > 0.0 ? 0.5 * (before - after) / bend : 0.0;
  return (static_cast<double>(index) - most + between) * step;
}

std::vector<Pair> pairs_of(const SensorLog& log, const ToldOdometry& odometry) {
  std::vector<Pair> pairs;
  const LaserScan* before = nullptr;
  for (const Measurement& measurement : log) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr || scan->laser != 0 || scan->bearing_step == 0.0) continue;
    const LaserScan* last = std::exchange(before, scan);
    const bool follow =
        last != nullptr && scan->time > last->time && scan->time - last->time <= kLongestStep &&
        last->ranges.size() == scan->ranges.size() && last->bearing_step == scan->bearing_step;
    if (!follow) continue;
    const auto motion = odometry.motion(last->time, scan->time);
    if (!motion || std::hypot(motion->x, motion->y) > kShortestWay) continue;
    const double wider = scan->time - last->time + 2.0 * kLongestLag;
    const auto about = odometry.motion(last->time - kLongestLag, scan->time + kLongestLag);
    const double turn = about ? std::abs(about->theta) * (scan->time - last->time) / wider : 0.0;
    if (std::max(turn, std::abs(motion->theta)) >= kTurns) pairs.push_back({last, scan});
  }
  if (pairs.size() <= kMostPairs) return pairs;
  std::vector<Pair> spread;
  for (std::size_t i = 0; i < kMostPairs; ++i) {
    spread.push_back(pairs[i * pairs.size() / kMostPairs]);
  }
  return spread;
}

struct Turn {
  double from = 0.0, to = 0.0;  // [s]
  double seen = 0.0;            // [rad]
};

// Mean squared difference to what odometry tells with so late stamps, without what is far off.
double difference(const std::vector<Turn>& turns, const ToldOdometry& odometry, double lag) {
  constexpr double kLargest = 0.04;  // [rad^2]
  double sum = 0.0;
  for (const Turn& turn : turns) {
    const auto motion = odometry.motion(turn.from + lag, turn.to + lag);
    const double off = motion ? normalized_angle(motion->theta - turn.seen) : 1.0;
    sum += std::min(kLargest, off * off);
  }
  return sum / static_cast<double>(turns.size());
}

}  // namespace

std::optional<double> odometry_lag(const SensorLog& log) {
  const ToldOdometry odometry(log);
  std::vector<Turn> turns;
  for (const Pair& pair : pairs_of(log, odometry)) {
    const std::optional<double> turn = turn_between(pair);
    if (turn) turns.push_back({pair.first->time, pair.second->time, *turn});
  }
  if (turns.size() < kFewestPairs) return {};
  const double without = difference(turns, odometry, 0.0);
  double lag = 0.0, least = without;
  const int most = static_cast<int>(std::lround(kLongestLag / kLagStep));
  for (int i = -most; i <= most; ++i) {
    const double off = difference(turns, odometry, i * kLagStep);
    if (off >= least) continue;
    least = off;
    lag = i * kLagStep;
  }
  // Odometry between two readings is their mean, which halves its noise. That alone is no lag: it
  // would be as good the other way.
  const bool clear = std::abs(lag) >= kLeastLag && least < 0.5 * without &&
                     least < 0.5 * difference(turns, odometry, -lag);
  return clear ? std::optional<double>(lag) : std::optional<double>{};
}

SensorLog without_lag(SensorLog log, double lag) {
  for (Measurement& measurement : log) {
    if (auto* reading = std::get_if<Odometry>(&measurement)) reading->time -= lag;
  }
  // Of one stamp odometry comes first: it tells where the scan was taken.
  std::stable_sort(log.begin(), log.end(), [](const Measurement& a, const Measurement& b) {
    const double at = time_of(a), bt = time_of(b);
    return at != bt ? at < bt : a.index() < b.index();
  });
  return log;
}

Remark remark_on_lag(double lag) {
  return {RemarkKind::odometry_lag,
          fmt::format("the stamps of odometry are {:.2f} s {}, by the turns that scans see: put "
                      "where they belong",
                      std::abs(lag), lag > 0.0 ? "late" : "early")};
}

}  // namespace mapbed
