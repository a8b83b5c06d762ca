#include "sim/drivers/scripted_driver.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;

constexpr double kDecideEvery = 0.05;  // [s]
constexpr double kArrived = 0.15;      // [m]
constexpr double kDetour = 1.5;        // [m] how far to look for a way round somebody
constexpr double kStandOff = 4.0;      // times its patience: then it makes room by backing up ...
constexpr double kRetreat = 7.0;       // [s] ... for so long
constexpr double kSlowly = 0.6;        // of the speed where it is tight
constexpr double kTurnGain = 2.0;      // [1/s]

// Of a point from the straight way between two others. [m]
double distance_to_way(const Vector2d& point, const Vector2d& from, const Vector2d& to) {
  return (nearest_point({from, to, 0.0}, point) - point).norm();
}

}  // namespace

ScriptedDriver::ScriptedDriver(const Simulation& simulation, const NamedPath& path,
                               const PathFollowingOptions& options)
    : simulation_(simulation), path_(path), options_(options) {
  CHECK(path_.points.size() >= 2);
}

double ScriptedDriver::longest_time() const {
  double seconds = 300.0;
  for (std::size_t i = 1; i < path_.points.size(); ++i) {
    const double speed = path_.points[i].speed > 0.0 ? path_.points[i].speed : options_.speed;
    const double way = (path_.points[i].position - path_.points[i - 1].position).norm();
    seconds += 5.0 * way / std::min(speed, simulation_.robot().drive.max_speed) + 5.0 +
               path_.points[i].pause;
  }
  return seconds;
}

Vector2d ScriptedDriver::target() {
  const Vector2d robot = simulation_.now().robot.position();
  for (;;) {
    const Vector2d& from = path_.points[leg_ - 1].position;
    const Vector2d& to = path_.points[leg_].position;
    const Vector2d way = to - from;
    const double length = way.norm();
    const Vector2d along = length > 0.0 ? Vector2d(way / length) : Vector2d(1.0, 0.0);
    progress_ = std::clamp((robot - from).dot(along), progress_, length);
    const bool is_stop = leg_ + 1 == path_.points.size() || path_.points[leg_].pause > 0.0;
    const double left = length - progress_;
    if (!is_stop && left < 0.5 * options_.look_ahead) {
      ++leg_;
      progress_ = 0.0;
      continue;
    }
    return from + std::min(length, progress_ + options_.look_ahead) * along;
  }
}

double ScriptedDriver::way_left() const {
  const WayPoint& next = path_.points[leg_];
  const bool is_stop = leg_ + 1 == path_.points.size() || next.pause > 0.0;
  return is_stop ? (next.position - simulation_.now().robot.position()).norm() : kDetour;
}

bool ScriptedDriver::is_free_of_walls(const Vector2d& to) const {
  const double reach = simulation_.robot().footprint.reach();
  return simulation_.navigation_map().is_straight_way(simulation_.now().robot.position(), to,
                                                      reach + options_.margin);
}

bool ScriptedDriver::is_free_of_people(const Vector2d& to) const {
  const Vector2d from = simulation_.now().robot.position();
  const double reach = simulation_.robot().footprint.reach();
  for (const Obstacle& person : simulation_.obstacles()) {
    if (!person.is_disc()) continue;
    const Vector2d soon = person.pose.position() + 0.5 * person.velocity;
    const double keep = reach + person.radius + options_.people_margin;
    // Whoever is near already does not stop a way that leads away from him.
    for (const Vector2d& place : {person.pose.position(), soon}) {
      const double d = distance_to_way(place, from, to);
      if (d < keep && (place - from).dot(to - from) > 0.0) return false;
    }
  }
  return true;
}

// The free direction nearest to that of `to`; the robot's own place where there is none.
Vector2d ScriptedDriver::way_round(const Vector2d& to) const {
  const Vector2d from = simulation_.now().robot.position();
  const Vector2d way = to - from;
  const double ahead = std::atan2(way.y(), way.x());
  for (int step = 1; step <= 10; ++step) {
    for (const double side : {-1.0, 1.0}) {  // on the right first
      const double direction = ahead + side * step * radians(10.0);
      const Vector2d there = from + kDetour * Vector2d(std::cos(direction), std::sin(direction));
      if (is_free_of_walls(there) && is_free_of_people(there)) return there;
    }
  }
  return from;
}

double ScriptedDriver::braking_speed() const {
  return std::sqrt(2.0 * 0.5 * simulation_.robot().drive.acceleration * std::max(0.02, way_left()));
}

DriveCommand ScriptedDriver::steer(const Vector2d& to, double speed) {
  const Pose2 robot = simulation_.now().robot;
  const Vector2d way = inverse(robot) * to;
  if (way.norm() < 1e-3) return {};
  const double bearing = std::atan2(way.y(), way.x());
  const double turn_limit = std::min(1.0, simulation_.robot().drive.max_turn_speed);
  DriveCommand command;
  command.turn_velocity = std::clamp(kTurnGain * bearing, -turn_limit, turn_limit);
  // Turns on the spot where the way leads aside, and does not run past the next stop.
  const double facing = std::max(0.0, 1.0 - std::abs(bearing) / radians(60.0));
  command.forward_velocity = facing * std::min(speed, braking_speed());
  return command;
}

// Straight back the way it came, as long as that is free.
DriveCommand ScriptedDriver::back_up() const {
  const Pose2 robot = simulation_.now().robot;
  const Vector2d behind = robot * Vector2d(-0.5, 0.0);
  const double half_width = simulation_.robot().footprint.inner_radius();
  const bool is_free =
      simulation_.navigation_map().is_straight_way(robot.position(), behind, half_width + 0.03) &&
      is_free_of_people(behind);
  return {.forward_velocity = is_free ? -0.2 : 0.0, .turn_velocity = 0.0};
}

DriveCommand ScriptedDriver::command(double time) {
  if (is_done_ || time < pause_until_) return {};
  if (time < retreat_until_) return back_up();
  if (asked_ >= 0.0 && time < asked_ + kDecideEvery - 1e-9) return last_;
  asked_ = time;
  last_ = {};

  const Vector2d to = target();
  const WayPoint& next = path_.points[leg_];
  const Vector2d robot = simulation_.now().robot.position();
  const bool is_last = leg_ + 1 == path_.points.size();
  if ((is_last || next.pause > 0.0) && (next.position - robot).norm() < kArrived) {
    pause_until_ = time + next.pause;
    is_done_ = is_last;
    if (!is_last) ++leg_, progress_ = 0.0;
    return last_;
  }

  // Off the path by a detour: back to it round the walls.
  double speed = next.speed > 0.0 ? next.speed : options_.speed;
  Vector2d aim = to;
  if (!is_free_of_walls(to)) {
    const double reach = simulation_.robot().footprint.reach();
    const auto way = simulation_.navigation_map().way(robot, to, reach + 0.5 * options_.margin);
    if (way) aim = (*way)[1];
    speed *= kSlowly;
  }
  if (is_free_of_people(aim)) {
    wait_since_ = -1.0;
    return last_ = steer(aim, speed);
  }
  return last_ = give_way(aim, time, speed);
}

// Somebody is in the way: waits, then goes round, then makes room.
DriveCommand ScriptedDriver::give_way(const Vector2d& aim, double time, double speed) {
  if (wait_since_ < 0.0) wait_since_ = time;
  const double waited = time - wait_since_;
  if (waited < options_.patience) return {};
  if (waited > kStandOff * options_.patience) {
    retreat_until_ = time + kRetreat;
    wait_since_ = -1.0;
  }
  return steer(way_round(aim), kSlowly * speed);
}

}  // namespace mapbed
