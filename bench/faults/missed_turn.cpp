#include "bench/faults/missed_turn.h"

#include <algorithm>
#include <cmath>

#include "bench/faults/fault_instants.h"
#include "bench/faults/odometry_steps.h"

namespace mapbed {
namespace {

constexpr double kLongestTurn = 10.0;  // [s]

std::vector<OdometryStep> steps_in(const SensorLog& log) {
  std::vector<OdometryStep> steps;
  (void)with_steps(log, [&steps](const OdometryStep& step) {
    steps.push_back(step);
    return step.motion;
  });
  return steps;
}

// [rad] the largest net turn, to either side, that begins with a step and is soon over.
double turn_from(const std::vector<OdometryStep>& steps, std::size_t first) {
  double net = 0.0;
  double largest = 0.0;
  for (std::size_t i = first; i < steps.size(); ++i) {
    if (steps[i].to - steps[first].from > kLongestTurn) break;
    net += steps[i].motion.theta;
    largest = std::max(largest, std::abs(net));
  }
  return largest;
}

// Where one of that size begins; where there is none, the largest one.
std::vector<double> instants_of_turns(const SensorLog& log, double turn, Rng& rng) {
  const std::vector<OdometryStep> steps = steps_in(log);
  std::vector<double> found;
  std::size_t largest = 0;
  double largest_turn = -1.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].motion.theta == 0.0) continue;  // a turn begins with turning
    const double here = turn_from(steps, i);
    if (here >= turn) found.push_back(steps[i].from);
    if (here > largest_turn) largest = i;
    largest_turn = std::max(largest_turn, here);
  }
  if (!found.empty()) return {found[rng.index(found.size())]};
  if (largest_turn < 0.0) return {};
  return {steps[largest].from};
}

// Takes the turn out of the steps from an instant on.
class Misser {
 public:
  Misser(double at, double turn) : at_(at), turn_(turn) {}

  Pose2 told(const OdometryStep& step) {
    if (step.from < at_ || is_over_) return step.motion;
    if (!has_begun_) when_.from = step.from;
    has_begun_ = true;
    when_.to = step.to;
    const double before = missed_;
    missed_ += step.motion.theta;
    is_over_ = std::abs(missed_) >= turn_;
    const double at_most = std::copysign(turn_, missed_);
    return {step.motion.x, step.motion.y, is_over_ ? step.motion.theta - (at_most - before) : 0.0};
  }
  bool has_begun() const { return has_begun_; }
  const TimeInterval& when() const { return when_; }

 private:
  double at_;            // [s]
  double turn_;          // [rad]
  double missed_ = 0.0;  // [rad] net
  bool has_begun_ = false;
  bool is_over_ = false;
  TimeInterval when_;
};

}  // namespace

BrokenLog with_missed_turn(SensorLog log, const MissedTurnOptions& options, Rng rng) {
  if (options.turn <= 0.0) return {std::move(log)};
  BrokenLog broken{std::move(log)};
  const std::vector<double> instants =
      options.at.empty() ? instants_of_turns(broken.log, options.turn, rng)
                         : fault_instants(broken.log, options.at, kLongestTurn, rng);
  for (const double at : instants) {
    Misser misser(at, options.turn);
    broken.log = with_steps(std::move(broken.log),
                            [&misser](const OdometryStep& step) { return misser.told(step); });
    if (misser.has_begun()) broken.when.push_back(misser.when());
  }
  return broken;
}

}  // namespace mapbed
