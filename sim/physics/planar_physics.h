#pragma once

#include <memory>
#include <optional>

#include "core/random.h"
#include "sim/actors/obstacle.h"
#include "sim/physics/touch.h"
#include "sim/physics/wheels.h"
#include "worlds/world.h"

namespace mapbed {

// Bodies on a flat floor: one robot that pushes against walls, doors and people, none of which it
// can move. Fixed steps, the same result on every run.
class PlanarPhysics {
 public:
  // Everything solid of the world below the robot's height is an obstacle, door leaves excepted.
  PlanarPhysics(const World& world, const Robot& robot, const Pose2& start, const Rng& rng);
  ~PlanarPhysics();
  PlanarPhysics(PlanarPhysics&&) noexcept;
  PlanarPhysics& operator=(PlanarPhysics&&) noexcept;

  // Something that goes where somebody else takes it; gives an id for move().
  int add(const Obstacle& obstacle);
  // During the next step it gets from where it is to `pose`.
  void move(int id, const Pose2& pose);

  void step(const DriveCommand& command, double dt);

  Pose2 robot() const;  // world_from_robot
  Twist2 robot_velocity() const;
  const Wheels& wheels() const;
  std::optional<Touch> touched() const;  // by the robot, the first of several
  bool is_touching() const { return touched().has_value(); }

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mapbed
