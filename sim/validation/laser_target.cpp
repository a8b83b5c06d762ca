#include "sim/validation/laser_target.h"

#include <algorithm>
#include <cmath>

namespace mapbed {
namespace {

constexpr double kThickness = 0.002;  // [m] of walls; no beam shall see their sides
constexpr double kWidth = 40.0;       // [m] of what has no end
constexpr double kHeight = 2.0;       // [m]

// [m] half the width of the beam's spot.
double half_spot(const LaserModel& laser, double distance) {
  return (laser.aperture + laser.divergence * distance) / 2.0;
}

Entity standing(const std::string& name, const Geometry& geometry, const Pose2& pose,
                int material) {
  Entity entity;
  entity.name = name;
  entity.world_from_entity = upright(pose, kHeight / 2.0);
  entity.parts = {{name, geometry, {}, material}};
  return entity;
}

std::optional<Meeting> meeting(const LaserTarget::Flat& flat, const Eigen::Vector2d& origin,
                               const Eigen::Vector2d& direction) {
  const Eigen::Vector2d normal(-std::cos(flat.incidence), -std::sin(flat.incidence));
  const double approach = -normal.dot(direction);
  if (approach <= 0.0) return std::nullopt;
  const double range = -normal.dot(Eigen::Vector2d(flat.distance, 0.0) - origin) / approach;
  if (range <= 0.0) return std::nullopt;
  if (flat.below && origin.y() + range * direction.y() >= 0.0) return std::nullopt;
  return Meeting{range, approach, normal, 0, flat.material};
}

std::optional<Meeting> meeting(const LaserTarget::Round& round, const Eigen::Vector2d& origin,
                               const Eigen::Vector2d& direction) {
  const Eigen::Vector2d to_axis = Eigen::Vector2d(round.distance, 0.0) - origin;
  const double along = to_axis.dot(direction);
  const double square = round.radius * round.radius - (to_axis.squaredNorm() - along * along);
  if (square <= 0.0) return std::nullopt;
  const double range = along - std::sqrt(square);
  const Eigen::Vector2d normal = (range * direction - to_axis) / round.radius;
  return Meeting{range, -normal.dot(direction), normal, 0, round.material};
}

}  // namespace

LaserTarget wall_target(const std::string& material, double distance, double incidence) {
  return {.flats = {{distance, incidence, material}}};
}

LaserTarget glass_target(double distance, double incidence, double gap) {
  return {.flats = {{distance, incidence, "glass"}, {distance + gap, 0.0, "plaster"}}};
}

LaserTarget edge_target(const LaserModel& laser, double distance, double gap) {
  return {.flats = {{distance, 0.0, "plaster", true}, {distance + gap, 0.0, "plaster"}},
          .half_width = half_spot(laser, distance)};
}

LaserTarget leg_target(const LaserModel& laser, double distance, double radius, double gap) {
  return {.flats = {{distance + gap, 0.0, "plaster"}},
          .rounds = {{distance, radius, "clothes"}},
          .half_width = radius + half_spot(laser, distance)};
}

World world_of(const LaserTarget& target) {
  World world;
  world.name = "laser target";
  for (const LaserTarget::Flat& flat : target.flats) {
    // The block stands behind its surface; one with an edge reaches from it to y = -width / 2.
    const Pose2 world_from_surface{flat.distance, 0.0, flat.incidence};
    const double width = flat.below ? kWidth / 2.0 : kWidth;
    const Pose2 surface_from_middle{kThickness / 2.0, flat.below ? -width / 2.0 : 0.0, 0.0};
    world.entities.push_back(standing("wall", Box{{kThickness, width, kHeight}},
                                      world_from_surface * surface_from_middle,
                                      material_index(world, flat.material)));
  }
  for (const LaserTarget::Round& round : target.rounds) {
    world.entities.push_back(standing("leg", Cylinder{round.radius, kHeight},
                                      {round.distance, 0.0, 0.0},
                                      material_index(world, round.material)));
  }
  return world;
}

std::vector<Meeting> meetings(const LaserTarget& target, const Eigen::Vector2d& origin,
                              const Eigen::Vector2d& direction) {
  std::vector<Meeting> found;
  int surface = 0;
  const auto look_at = [&](const auto& thing) {
    if (auto met = meeting(thing, origin, direction)) {
      met->surface = surface;
      found.push_back(*met);
    }
    ++surface;
  };
  for (const LaserTarget::Flat& flat : target.flats) look_at(flat);
  for (const LaserTarget::Round& round : target.rounds) look_at(round);
  std::sort(found.begin(), found.end(),
            [](const Meeting& a, const Meeting& b) { return a.range < b.range; });
  return found;
}

}  // namespace mapbed
