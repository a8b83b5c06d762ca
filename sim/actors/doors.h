#pragma once

#include <span>
#include <vector>

#include "core/random.h"
#include "sim/actors/floor_plan.h"
#include "worlds/world.h"

namespace mapbed {

// Something that a door opens for and that stops its leaf.
struct DoorVisitor {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m]
  double radius = 0.3;                                 // [m]
};

// The doors of a world: hinged leaves that open for who comes near and shut again, or open and shut
// by chance. A leaf that would touch somebody waits.
class Doors {
 public:
  Doors(const World& world, const Rng& rng);

  void step(std::span<const DoorVisitor> visitors, double dt);

  std::size_t size() const { return doors_.size(); }
  const Door& door(std::size_t index) const { return doors_[index].door; }
  double angle(std::size_t index) const { return doors_[index].angle; }  // [rad] 0: shut
  bool is_moving(std::size_t index) const { return doors_[index].is_moving; }
  Pose2 world_from_leaf(std::size_t index) const;
  const std::vector<Wall>& walls() const { return walls_; }  // the leaves, for who walks

 private:
  struct State {
    Door door;
    Rng rng;
    double angle;  // [rad] signed as open_angle
    bool wants_open;
    bool is_moving = false;
    double change_at;  // [s] when chance changes its mind; infinite: never
  };
  void decide(State& s, std::span<const DoorVisitor> visitors) const;
  void update_walls();

  std::vector<State> doors_;
  std::vector<Wall> walls_;
  double time_ = 0.0;  // [s]
};

}  // namespace mapbed
