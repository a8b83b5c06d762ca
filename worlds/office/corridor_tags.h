#pragma once

#include <vector>

#include "core/random.h"
#include "worlds/world.h"

namespace mapbed {

// A straight piece of a wall's surface on which tags may be.
struct TagStrip {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();  // [m]
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  double facing = 0.0;  // [rad] away from the wall
};

// So many tags along all strips, "tag_001" on, each within a piece of its own of their length, 1 m
// to 1.6 m high.
void add_tags(World& world, const std::vector<TagStrip>& strips, int count, int material, Rng rng);

}  // namespace mapbed
