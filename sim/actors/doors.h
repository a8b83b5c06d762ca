#pragma once

#include <vector>

#include "core/random.h"
#include "sim/actors/actor.h"
#include "worlds/world.h"

namespace mapbed {

// The doors of a world: hinged leaves that open for who comes near and shut again, or open and shut
// by chance. The robot and every disc that moves is a visitor; a leaf that would touch one waits.
class Doors : public Actor {
 public:
  Doors(const World& world, const Rng& rng);

  void step(double dt, const SimState& state) override;
  void append_obstacles(std::vector<Obstacle>& obstacles) const override;
  void append_poses(std::vector<MovingPose>& poses) const override;

  std::size_t size() const { return doors_.size(); }
  const Door& door(std::size_t index) const { return doors_[index].door; }
  double angle(std::size_t index) const { return doors_[index].angle; }  // [rad] 0: shut
  Pose2 world_from_leaf(std::size_t index) const;

 private:
  struct State {
    Door door;
    std::vector<Pose3> leaf_from_part;
    Rng rng;
    double angle;  // [rad] signed as open_angle
    bool wants_open;
    bool is_moving = false;
    double change_at;  // [s] when chance changes its mind; infinite: never
  };
  void decide(State& s, const SimState& state) const;

  std::vector<State> doors_;
  double time_ = 0.0;  // [s]
};

}  // namespace mapbed
