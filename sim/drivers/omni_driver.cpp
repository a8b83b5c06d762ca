#include "sim/drivers/omni_driver.h"

#include <algorithm>
#include <cmath>

namespace mapbed {
namespace {

using Eigen::Vector2d;

constexpr double kTurnGain = 2.0;      // [1/s]
constexpr double kRetreatSpeed = 0.2;  // [m/s]

DriveCommand straight_to(const Vector2d& in_robot, double speed) {
  const Vector2d velocity = speed * in_robot.normalized();
  return {.forward_velocity = velocity.x(), .left_velocity = velocity.y()};
}

}  // namespace

DriveCommand OmniDriver::steer(const Vector2d& to, double speed) {
  const Pose2 robot = simulation().now().robot;
  const Vector2d way = inverse(robot) * to;
  if (way.norm() < 1e-3) return {};
  last_way_ = (to - robot.position()).normalized();
  DriveCommand command = straight_to(way, std::min(speed, braking_speed()));
  if (options_.faces_way) {
    const double bearing = std::atan2(way.y(), way.x());
    command.turn_velocity =
        std::clamp(kTurnGain * bearing, -options_.turn_speed, options_.turn_speed);
  }
  return command;
}

// Against the way that it came, as long as that is free.
DriveCommand OmniDriver::back_up() const {
  const Pose2 robot = simulation().now().robot;
  const Vector2d behind = robot.position() - 0.5 * last_way_;
  const bool is_free = is_free_of_walls(behind) && is_free_of_people(behind);
  return is_free ? straight_to(inverse(robot) * behind, kRetreatSpeed) : DriveCommand{};
}

}  // namespace mapbed
