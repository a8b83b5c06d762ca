#include "bench/faults/fault_instants.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/pose2.h"

namespace mapbed {
namespace {

constexpr double kMetersPerRadian = 0.5;
constexpr double kMargin = 0.1;  // of the log's duration, at either end

// How much the robot had moved at a stamp.
struct Moved {
  double time;    // [s]
  double amount;  // [m] since the first reading
};

std::vector<Moved> motion_in(const SensorLog& log) {
  std::vector<Moved> moved;
  const Odometry* last = nullptr;
  for (const Measurement& measurement : log) {
    const auto* reading = std::get_if<Odometry>(&measurement);
    if (reading == nullptr) continue;
    double amount = 0.0;
    if (last != nullptr) {
      const Pose2 step = motion_between(last->odometry_from_robot, reading->odometry_from_robot);
      amount = moved.back().amount + std::hypot(step.x, step.y) +
               kMetersPerRadian * std::abs(step.theta);
    }
    moved.push_back({reading->time, amount});
    last = reading;
  }
  return moved;
}

// During the seconds after a stamp.
double amount_after(const std::vector<Moved>& moved, std::size_t from, double seconds) {
  const auto end = std::upper_bound(moved.begin(), moved.end(), moved[from].time + seconds,
                                    [](double time, const Moved& m) { return time < m.time; });
  return std::prev(end)->amount - moved[from].amount;
}

// Stamps in the log's middle after which the robot moves at least as much as on average; where
// there are none, the one after which it moves most.
std::vector<double> lively_stamps(const SensorLog& log, double seconds) {
  const std::vector<Moved> moved = motion_in(log);
  const TimeInterval whole = whole_of(log);
  const double duration = whole.to - whole.from;
  const double average =
      moved.empty() || duration <= 0.0 ? 0.0 : moved.back().amount / duration * seconds;
  std::vector<double> lively;
  double most = -1.0;
  double liveliest = whole.from + 0.5 * duration;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const double since_start = moved[i].time - whole.from;
    if (since_start < kMargin * duration || since_start > (1.0 - kMargin) * duration) continue;
    const double amount = amount_after(moved, i, seconds);
    if (amount > 0.0 && amount >= average) lively.push_back(moved[i].time);
    if (amount > most) liveliest = moved[i].time;
    most = std::max(most, amount);
  }
  if (lively.empty()) lively.push_back(liveliest);
  return lively;
}

}  // namespace

TimeInterval whole_of(const SensorLog& log) {
  return {time_of(log.front()), time_of(log.back())};
}

std::vector<double> fault_instants(const SensorLog& log, const std::vector<double>& at,
                                   double seconds, Rng& rng) {
  if (log.empty()) return {};
  std::vector<double> stamps;
  for (const double since_start : at) stamps.push_back(time_of(log.front()) + since_start);
  if (stamps.empty()) {
    const std::vector<double> lively = lively_stamps(log, seconds);
    stamps.push_back(lively[rng.index(lively.size())]);
  }
  std::sort(stamps.begin(), stamps.end());
  return stamps;
}

}  // namespace mapbed
