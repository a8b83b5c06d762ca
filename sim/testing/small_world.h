#pragma once

#include <string>

#include "worlds/world.h"

namespace mapbed {

// A solid block standing on the floor, seen from above.
inline Entity block(const std::string& name, const Eigen::Vector2d& center,
                    const Eigen::Vector2d& size, int material = 0) {
  Entity entity;
  entity.name = name;
  constexpr double kHeight = 2.5;
  entity.world_from_entity = upright({center.x(), center.y(), 0.0}, kHeight / 2.0);
  entity.parts = {{"block", Box{{size.x(), size.y(), kHeight}}, {}, material}};
  return entity;
}

// A floor under the room, 10 cm thick.
inline void add_floor(World& world) {
  Entity floor;
  floor.name = "floor";
  floor.kind = EntityKind::floor;
  floor.parts = {{"floor", Box{{100.0, 100.0, 0.1}}, upright({}, -0.05), 0}};
  world.entities.push_back(floor);
}

// A room between (0, 0) and (length, width) with walls 20 cm thick around it.
inline World small_room(double length, double width) {
  World world;
  world.name = "small room";
  const double l = length + 0.4;
  world.entities = {block("south wall", {length / 2, -0.1}, {l, 0.2}),
                    block("north wall", {length / 2, width + 0.1}, {l, 0.2}),
                    block("west wall", {-0.1, width / 2}, {0.2, width}),
                    block("east wall", {length + 0.1, width / 2}, {0.2, width})};
  return world;
}

}  // namespace mapbed
