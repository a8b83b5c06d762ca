#pragma once

#include <vector>

#include "core/random.h"
#include "sim/actors/actor.h"
#include "worlds/world.h"

namespace mapbed {

// What somebody moves from place to place in a world, chairs and trolleys: each rests for a while
// by chance, is moved straight to its next place, and rests again. Who moves it is not seen. It
// waits for a disc that is in its way, the robot's too; people do not look out for it, their
// routes keep off.
class Movables : public Actor {
 public:
  // `first_entity` is the id of the first one's entity.
  Movables(const World& world, int first_entity, const Rng& rng);

  std::vector<Entity> entities() const override;
  void step(double dt, const SimState& state) override;
  void append_obstacles(std::vector<Obstacle>& obstacles) const override;
  void append_poses(std::vector<MovingPose>& poses) const override;

 private:
  struct State {
    Movable movable;
    Rng rng;
    double radius;                                       // [m] of the circle about it
    Eigen::Vector2d position;                            // [m]
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // [m/s]
    std::size_t next = 1;                                // place that it is moved to, or will be
    double rests_until = 0.0;                            // [s]
  };
  Pose3 world_from_entity(const State& state) const;

  std::vector<State> movables_;
  int first_entity_;
  double time_ = 0.0;  // [s]
};

}  // namespace mapbed
