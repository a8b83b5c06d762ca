#include "sim/stuck.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/geometry/angle.h"
#include "worlds/geometry/footprint.h"

namespace mapbed {
namespace {

constexpr double kMoved = 0.05;         // [m]
constexpr double kTurned = 0.1;         // [rad]
constexpr double kPeople = 2.0;         // [m] further ones are in nobody's way
constexpr double kOverTheFloor = 0.02;  // [m] what is lower is driven over

std::string name_of(const Obstacle& obstacle) {
  return fmt::format("{} at ({:.2f} m, {:.2f} m)",
                     obstacle.is_disc() ? "somebody" : "a door's leaf", obstacle.pose.x,
                     obstacle.pose.y);
}

const Obstacle* nearest_person(const Simulation& simulation) {
  const Obstacle* nearest = nullptr;
  double least = kPeople;
  for (const Obstacle& obstacle : simulation.obstacles()) {
    const double distance =
        (obstacle.pose.position() - simulation.now().robot.position()).norm() - obstacle.radius;
    if (!obstacle.is_disc() || distance >= least) continue;
    least = distance;
    nearest = &obstacle;
  }
  return nearest;
}

std::string nearest_thing(const Simulation& simulation) {
  const World& world = simulation.world();
  std::string name = "nothing";
  double least = std::numeric_limits<double>::infinity();
  for (const Footprint& f : footprints(world, kOverTheFloor, simulation.robot().height)) {
    const Entity& entity = world.entities[static_cast<std::size_t>(f.entity)];
    if (entity.kind == EntityKind::floor || entity.kind == EntityKind::door) continue;
    const double distance = distance_to(f, simulation.now().robot.position());
    if (distance >= least) continue;
    least = distance;
    name = "'" + entity.name + "'";
  }
  return name;
}

}  // namespace

bool StuckWatch::is_stuck(const Situation& now, bool is_resting) {
  const bool moved = (now.robot.position() - place_.position()).norm() > kMoved ||
                     std::abs(angle_difference(now.robot.theta, place_.theta)) > kTurned;
  if (!has_begun_ || moved || is_resting) {
    has_begun_ = true;
    place_ = now.robot;
    since_ = now.time;
  }
  return patience_ > 0.0 && now.time - since_ >= patience_;
}

std::string what_is_in_the_way(const Simulation& simulation) {
  if (const auto touch = simulation.touched()) {
    if (touch->entity >= 0) return "stuck by '" + simulation.entity(touch->entity).name + "'";
    return "stuck by " + name_of(simulation.obstacles()[static_cast<std::size_t>(touch->mover)]);
  }
  const Obstacle* person = nearest_person(simulation);
  if (person != nullptr) return "stuck by " + name_of(*person);
  return "though it touches nothing; nearest to it is " + nearest_thing(simulation);
}

}  // namespace mapbed
