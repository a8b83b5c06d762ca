#include "algorithms/input/odometry_check.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/statistics/quantile.h"

namespace mapbed {
namespace {

constexpr double kLeastSeconds = 0.25;    // between readings: stamps may be that far off
constexpr double kLongestStall = 2.5;     // [s] that counters stand still and then tell all at once
constexpr double kKeepsMoving = 0.5;      // [s] for which a robot goes on as before
constexpr std::size_t kLeastSteps = 100;  // fewer do not tell what is usual
constexpr double kFast = 0.98;            // fraction of the moving steps that are slower
// A log in which the robot crept may show more of it.
constexpr double kLeastSpeed = 0.5;     // [m/s]
constexpr double kLeastTurnRate = 1.0;  // [rad/s]
constexpr double kSame = 1e-6;          // [m], [rad] counters that begin again have the same pose

double turn_of(const Pose2& step) {
  return std::abs(step.theta);
}

double length_of(const Pose2& step) {
  return std::hypot(step.x, step.y);
}

bool are_same(const Pose2& a, const Pose2& b) {
  return std::abs(a.x - b.x) < kSame && std::abs(a.y - b.y) < kSame &&
         std::abs(a.theta - b.theta) < kSame;
}

}  // namespace

std::optional<UsualMotion> usual_motion(const SensorLog& log) {
  std::vector<double> speeds, turn_rates;
  const Odometry* last = nullptr;
  for (const Measurement& measurement : log) {
    const auto* reading = std::get_if<Odometry>(&measurement);
    if (reading == nullptr) continue;
    if (last != nullptr && last->odometry_from_robot != reading->odometry_from_robot) {
      const Pose2 step = motion_between(last->odometry_from_robot, reading->odometry_from_robot);
      const double seconds = std::max(kLeastSeconds, reading->time - last->time);
      speeds.push_back(length_of(step) / seconds);
      turn_rates.push_back(turn_of(step) / seconds);
    }
    last = reading;
  }
  if (speeds.size() < kLeastSteps) return {};
  return UsualMotion{quantile_of(std::move(speeds), kFast),
                     quantile_of(std::move(turn_rates), kFast)};
}

OdometryCheck::OdometryCheck(const OdometryCheckOptions& options,
                             const std::optional<UsualMotion>& usual)
    : options_(options), max_speed_(options.max_speed), max_turn_rate_(options.max_turn_rate) {
  if (usual) usual_ = *usual;
  usual_.speed = std::max(usual_.speed, kLeastSpeed);
  usual_.turn_rate = std::max(usual_.turn_rate, kLeastTurnRate);
  if (!usual) return;
  max_speed_ = std::min(max_speed_, options.usual_times * usual_.speed);
  max_turn_rate_ = std::min(max_turn_rate_, options.usual_times * usual_.turn_rate);
}

bool OdometryCheck::has_jumped(const Pose2& step, double seconds) const {
  return length_of(step) > max_speed_ * seconds || turn_of(step) > max_turn_rate_ * seconds;
}

// At zero or where the log began, and not because the robot came by there: then it was near before.
bool OdometryCheck::has_restarted(const Odometry& reading, const Pose2& step,
                                  double seconds) const {
  const Pose2& pose = reading.odometry_from_robot;
  if (!are_same(pose, {}) && !are_same(pose, first_->odometry_from_robot)) return false;
  const double moving = std::clamp(seconds, kLeastSeconds, 1.0);
  return length_of(step) > usual_.speed * moving || turn_of(step) > usual_.turn_rate * moving;
}

Pose2 OdometryCheck::guessed_step(double seconds) const {
  const bool goes_on = seconds <= kKeepsMoving && last_seconds_ > 0.0 && last_seconds_ <= 1.0;
  return goes_on ? interpolate({}, last_step_, seconds / std::max(last_seconds_, seconds / 2.0))
                 : Pose2{};
}

Odometry OdometryCheck::checked(Odometry reading) {
  const Odometry given = reading;
  if (!last_) {
    first_ = last_ = given;
    changed_ = given.time;
    passed_ = given.odometry_from_robot;
    return reading;
  }
  const double seconds = given.time - last_->time;
  Pose2 step = motion_between(last_->odometry_from_robot, given.odometry_from_robot);
  const double since_change = std::min(given.time - changed_, kLongestStall);
  const bool restarts = has_restarted(given, step, seconds);
  const bool jumps =
      !restarts && has_jumped(step, std::max({kLeastSeconds, seconds, since_change}));
  restarts_.tell(given.time, restarts);
  jumps_.tell(given.time, jumps);
  if (jumps || restarts) {
    if (jumps) largest_jump_ = std::max(largest_jump_, length_of(step));
    step = guessed_step(seconds);
    passed_from_odometry_ = passed_ * step * inverse(given.odometry_from_robot);
    reading.motion_unknown = true;
  }
  if (passed_from_odometry_) {
    reading.odometry_from_robot = *passed_from_odometry_ * given.odometry_from_robot;
  }
  if (jumps || restarts || !are_same(given.odometry_from_robot, last_->odometry_from_robot)) {
    changed_ = given.time;
  }
  passed_ = reading.odometry_from_robot;
  last_step_ = step;
  last_seconds_ = seconds;
  last_ = given;
  return reading;
}

std::vector<Remark> OdometryCheck::remarks(double start) const {
  std::vector<Remark> result =
      remarks_on(jumps_, RemarkKind::odometry_jump, start, "odometry jumps",
                 fmt::format(" (by up to {:.1f} m): it goes on from where it was", largest_jump_));
  for (Remark& remark : remarks_on(restarts_, RemarkKind::odometry_restart, start,
                                   "odometry begins again", ": it goes on from where it was")) {
    result.push_back(std::move(remark));
  }
  return result;
}

}  // namespace mapbed
