#include "algorithms/motion/motion_model.h"

#include <cmath>

#include <Eigen/Dense>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr double kLeastWay = 0.01;  // [m] below this the direction of the way means nothing

struct Spreads {
  double alpha, way, beta;
};

Spreads spreads_of(const TurnWayTurn& motion, const MotionModelOptions& o) {
  const double d = std::abs(motion.way);
  const auto turn_spread = [&](double turn) {
    return std::sqrt(o.turn_noise * o.turn_noise * std::abs(turn) +
                     o.turn_per_meter * o.turn_per_meter * d + o.floor_turn * o.floor_turn);
  };
  return {
      turn_spread(motion.alpha),
      std::sqrt(o.way_per_meter * o.way_per_meter * d +
                o.way_per_turn * o.way_per_turn * (std::abs(motion.alpha) + std::abs(motion.beta)) +
                o.floor_way * o.floor_way),
      turn_spread(motion.beta)};
}

TurnWayTurn corrected(TurnWayTurn motion, const MotionModelOptions& o) {
  motion.alpha -= o.turn_bias * motion.alpha;
  motion.beta -= o.turn_bias * motion.beta;
  motion.way -= o.way_bias * motion.way;
  return motion;
}

Pose2 composed(const TurnWayTurn& motion) {
  return {motion.way * std::cos(motion.alpha), motion.way * std::sin(motion.alpha),
          normalized_angle(motion.alpha + motion.beta)};
}

}  // namespace

TurnWayTurn decomposed(const Pose2& motion) {
  const double way = std::hypot(motion.x, motion.y);
  if (way < kLeastWay) return {0.0, motion.x, motion.theta};
  double alpha = std::atan2(motion.y, motion.x);
  const bool backwards = std::abs(alpha) > kPi / 2;
  if (backwards) alpha = normalized_angle(alpha + kPi);
  return {alpha, backwards ? -way : way, normalized_angle(motion.theta - alpha)};
}

Pose2 sampled_motion(const Pose2& measured, const MotionModelOptions& options, Rng& rng) {
  const TurnWayTurn motion = corrected(decomposed(measured), options);
  const Spreads spread = spreads_of(motion, options);
  const Pose2 result =
      composed({rng.normal(motion.alpha, spread.alpha), rng.normal(motion.way, spread.way),
                rng.normal(motion.beta, spread.beta)});
  return result * Pose2{0.0, rng.normal(0.0, options.floor_way), 0.0};
}

PosePrior gaussian_after(const Pose2& start, const Pose2& measured,
                         const MotionModelOptions& options) {
  const TurnWayTurn motion = corrected(decomposed(measured), options);
  const Spreads spread = spreads_of(motion, options);
  const Pose2 likeliest = composed(motion);
  // How the end moves with alpha, way and beta, in the frame of the end.
  Eigen::Matrix3d moves;
  const double sideways = motion.way;  // an error in alpha swings the end about the start
  const double c = std::cos(motion.beta), s = std::sin(motion.beta);
  moves << s * sideways, c, 0.0, c * sideways, -s, 0.0, 1.0, 0.0, 1.0;
  const Eigen::Vector3d variances(spread.alpha * spread.alpha, spread.way * spread.way,
                                  spread.beta * spread.beta);
  Eigen::Matrix3d covariance = moves * variances.asDiagonal() * moves.transpose();
  const double floor = options.floor_way * options.floor_way;
  covariance.diagonal() += Eigen::Vector3d(floor, floor, 1e-8);
  return {.mean = start * likeliest, .information = covariance.inverse()};
}

}  // namespace mapbed
