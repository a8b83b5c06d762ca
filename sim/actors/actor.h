#pragma once

#include <span>
#include <vector>

#include "sim/actors/moving_pose.h"
#include "sim/actors/obstacle.h"
#include "worlds/geometry/shape.h"

namespace mapbed {

// The moment as those see it who live in it.
struct SimState {
  Obstacle robot;                            // the circle around it
  std::span<const Obstacle> obstacles = {};  // of all groups; those that step first moved already
};

// A group of what moves by itself: all people, all doors. A new kind is a file pair in this folder
// and a line in the table of actors.cpp.
class Actor {
 public:
  virtual ~Actor() = default;

  // What it adds to the world, as it stands in the beginning; their ids follow one another from the
  // one that it was made with.
  virtual std::vector<Entity> entities() const { return {}; }

  virtual void step(double dt, const SimState& state) = 0;  // dt [s]

  // As it stands now: the same things in the same order every time, all parts of an entity one
  // after the other.
  virtual void append_obstacles(std::vector<Obstacle>& obstacles) const = 0;
  virtual void append_poses(std::vector<MovingPose>& poses) const = 0;
};

}  // namespace mapbed
