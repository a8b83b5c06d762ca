#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "worlds/world.h"

namespace mapbed {

// What buildings are made of. All add entities to the world.

// How a door stands and behaves.
struct DoorStyle {
  bool starts_open = false;
  bool hinge_at_end = false;  // of the opening, as the wall runs; else at its start
  bool opens_left = true;     // to the left of the wall as it runs; else to its right
  double mean_open = 0.0;     // [s] as in Door
  double mean_shut = 0.0;     // [s] as in Door
  double opens_within = 0.0;  // [m] as in Door
};

enum class OpeningKind { gap, door, glass };

// A hole in a wall. Gap: up to the ceiling. Door: with a frame and a lintel. Glass: panes between
// posts, from the floor to a lintel.
struct Opening {
  double at = 0.0;     // [m] of its middle along the wall
  double width = 1.0;  // [m]
  OpeningKind kind = OpeningKind::gap;
  DoorStyle door = {};
};

struct Wall {
  std::string name = "wall";
  Eigen::Vector2d from = Eigen::Vector2d::Zero();  // [m] middle line
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  double thickness = 0.15;  // [m]
  std::string material = "plaster";
  std::vector<Opening> openings = {};  // apart from each other, frames included
};

// What an opening of this kind takes of the wall on either side, for its frame. [m]
double frame_width(OpeningKind kind);

void add_wall(World& world, const Wall& wall);
// A rectangle of four walls: south, east, north, west.
void add_walls_around(World& world, const std::string& name, const Eigen::Vector2d& low,
                      const Eigen::Vector2d& high, double thickness = 0.15,
                      const std::string& material = "plaster");
void add_floor(World& world, const Eigen::Vector2d& low, const Eigen::Vector2d& high,
               const std::string& material);

}  // namespace mapbed
