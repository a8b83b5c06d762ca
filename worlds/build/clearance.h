#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "worlds/world.h"

namespace mapbed {

// A straight strip of floor that must stay clear.
struct ClearStrip {
  Eigen::Vector2d from;
  Eigen::Vector2d to;
  double clearance = 0.3;  // [m] to either side
};
Eigen::AlignedBox2d bounds_of(const ClearStrip& strip);  // of its middle line

// Of the world's paths, crowd routes and standing places, and where its door leaves turn.
std::vector<ClearStrip> clear_strips(const World& world);

// Throw InputError where a path or a crowd route runs too close to something (doors open), with the
// path, the thing and the place, or where a path has less than two points.
void check_clearance(const World& world, const NamedPath& path);
void check_clearance(const World& world, const CrowdRoute& route);
void check_clearance(const World& world);  // of all of them

}  // namespace mapbed
