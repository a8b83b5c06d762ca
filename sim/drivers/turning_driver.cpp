#include "sim/drivers/turning_driver.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr double kShortest = 1e-3;  // [s] of a pause, which makes a point a stop
constexpr double kGain = 2.0;       // [1/s] slows down at the end of a turn
constexpr double kSlowest = 0.05;   // [rad/s]

NamedPath with_stops(NamedPath path) {
  for (WayPoint& point : path.points) point.pause = std::max(point.pause, kShortest);
  return path;
}

}  // namespace

TurningDriver::TurningDriver(const Simulation& simulation, const NamedPath& path,
                             const TurningDriverOptions& options)
    : ScriptedDriver(simulation, with_stops(path), options),
      options_(options),
      stops_(path.points.size()),
      heading_(simulation.now().robot.theta) {}

DriveCommand TurningDriver::turn() {
  const double heading = simulation().now().robot.theta;
  turned_ += angle_difference(heading_, heading);
  heading_ = heading;
  const double left = 2.0 * kPi * std::abs(options_.turns) - std::abs(turned_);
  if (left <= 0.0) {
    is_turning_ = false;
    return {};
  }
  const double limit = std::min(options_.turn_speed, simulation().robot().drive.max_turn_speed);
  const double speed = std::clamp(kGain * left, std::min(kSlowest, limit), limit);
  return {.turn_velocity = std::copysign(speed, options_.turns)};
}

DriveCommand TurningDriver::command(double time) {
  if (is_turning_) return turn();
  const bool was_there = ScriptedDriver::is_resting(time);
  const DriveCommand command = ScriptedDriver::command(time);
  if (ScriptedDriver::is_resting(time) && !was_there) {
    is_turning_ = true;
    turned_ = 0.0;
    heading_ = simulation().now().robot.theta;
  }
  return command;
}

// Wheels that slip take up to three times as long.
double TurningDriver::longest_time() const {
  const double turn = 2.0 * kPi * std::abs(options_.turns) / options_.turn_speed + 10.0;
  return ScriptedDriver::longest_time() + 3.0 * turn * static_cast<double>(stops_);
}

}  // namespace mapbed
