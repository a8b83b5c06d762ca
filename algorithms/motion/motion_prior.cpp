#include "algorithms/motion/motion_prior.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

namespace mapbed {
namespace {

// [s] a robot that odometry shows standing for longer stands
constexpr double kLongestTime = 1.0;
// [s], [m] between two scans at least: an instant is no certainty
constexpr double kShortestTime = 0.05;

PosePrior spread_about(const Pose2& mean, const Pose2& motion, double seconds,
                       const MotionSpread& spread) {
  const MotionVariance variance = variance_after(motion, seconds, spread);
  const double position = std::sqrt(variance.position);
  return independent_prior(mean, position, position, std::sqrt(variance.heading));
}

// Half the logarithm of the volume that a belief spreads over, but for a constant.
double log_volume(const PosePrior& prior) {
  return -0.5 * prior.information.diagonal().array().log().sum();
}

}  // namespace

MotionVariance variance_after(const Pose2& motion, double seconds, const MotionSpread& spread) {
  const double way = std::hypot(motion.x, motion.y), turn = std::abs(motion.theta);
  const double time = std::clamp(seconds, kShortestTime, kLongestTime);
  const auto variance = [&](double per_meter, double per_turn, double per_time) {
    return per_meter * per_meter * way + per_turn * per_turn * turn + per_time * per_time * time;
  };
  return {variance(spread.position_per_meter, spread.position_per_turn, spread.position_per_time),
          variance(spread.heading_per_meter, spread.heading_per_turn, spread.heading_per_time)};
}

PosePrior predict(const Pose2& map_from_robot, const Pose2& motion, double seconds,
                  const MotionPriorOptions& options) {
  const Pose2 mean = map_from_robot * motion;
  PosePrior prior = spread_about(mean, motion, seconds, options.odometry);
  const PosePrior slip = spread_about(mean, motion, seconds, options.slip);
  prior.tail = slip.information;
  prior.tail_log = std::log(options.slip_share / (1.0 - options.slip_share)) + log_volume(prior) -
                   log_volume(slip);
  return prior;
}

PosePrior predict_blindly(const Pose2& map_from_robot, const Pose2& motion, double seconds,
                          const MotionPriorOptions& options) {
  const double position = options.position_sigma + options.speed_sigma * seconds;
  const double heading = options.heading_sigma + options.turn_speed_sigma * seconds;
  return independent_prior(map_from_robot * motion, position, position, heading);
}

}  // namespace mapbed
