#include "algorithms/motion/motion_prior.h"

#include <cmath>

namespace mapbed {

PosePrior predict(const Pose2& map_from_robot, const Pose2& motion,
                  const MotionPriorOptions& options) {
  const double translation = std::hypot(motion.x, motion.y), turn = std::abs(motion.theta);
  const double position = options.position_sigma + options.position_per_meter * translation +
                          options.position_per_turn * turn;
  const double heading = options.heading_sigma + options.heading_per_meter * translation +
                         options.heading_per_turn * turn;
  return independent_prior(map_from_robot * motion, position, position, heading);
}

PosePrior predict_blindly(const Pose2& map_from_robot, const Pose2& motion, double seconds,
                          const MotionPriorOptions& options) {
  const double position = options.position_sigma + options.speed_sigma * seconds;
  const double heading = options.heading_sigma + options.turn_speed_sigma * seconds;
  return independent_prior(map_from_robot * motion, position, position, heading);
}

}  // namespace mapbed
