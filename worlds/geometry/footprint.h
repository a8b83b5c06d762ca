#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "worlds/world.h"

namespace mapbed {

// What a part covers in the plan, between two heights.
struct Footprint {
  int entity = 0;
  int part = 0;
  int material = 0;
  // Convex or not, counter-clockwise; two points where a mesh triangle stands upright; empty: a
  // circle.
  std::vector<Eigen::Vector2d> outline = {};
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  // of the circle
  double radius = 0.0;
};

// Of everything solid that reaches into the open band between the two heights, floor and door
// leaves included. Upright boxes, cylinders and extrusions exactly; tilted ones and meshes as the
// pieces of their triangles within the band.
std::vector<Footprint> footprints(const World& world, double low, double high);
std::vector<Footprint> footprints(const Entity& entity, int id, double low, double high);

bool covers(const Footprint& footprint, const Eigen::Vector2d& point);

// From a point, a straight way or another footprint to the footprint's border; 0 where they touch
// or overlap. [m]
double distance_to(const Footprint& footprint, const Eigen::Vector2d& point);
double distance_to(const Footprint& footprint, const Eigen::Vector2d& from,
                   const Eigen::Vector2d& to);
double distance_between(const Footprint& a, const Footprint& b);

Eigen::AlignedBox2d bounds_of(const Footprint& footprint);

}  // namespace mapbed
