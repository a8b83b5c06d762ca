#pragma once

#include <memory>
#include <vector>

#include "core/random.h"
#include "sim/actors/actor.h"
#include "sim/actors/crowd_members.h"
#include "sim/actors/crowd_options.h"
#include "sim/actors/navigation_map.h"
#include "sim/actors/person_body.h"
#include "worlds/world.h"

namespace mapbed {

// A person as others see it.
struct PersonView {
  PersonKind kind;
  Obstacle body;  // its pose looks where the person does
  PersonPosture posture;
  Motion motion;  // moving: walks, faster than 0.1 m/s
};

// Everybody who is about: who they are is drawn at the start, person by person from a stream of its
// own; then they walk their routes, pause, keep together in pairs, stand, or block the robot. They
// walk round the robot and round leaves that move.
class Crowd : public Actor {
 public:
  // `first_entity` is the id of the first person's entity. Throws InputError where the world has no
  // routes or places for the people asked for, or where they do not fit.
  Crowd(const World& world, const NavigationMap& map, const Obstacle& robot,
        const CrowdOptions& options, int first_entity, const Rng& rng);
  ~Crowd() override;
  Crowd(Crowd&&) noexcept;
  Crowd& operator=(Crowd&&) noexcept;

  std::vector<Entity> entities() const override;
  void step(double dt, const SimState& state) override;  // in steps of 5 ms or less
  void append_obstacles(std::vector<Obstacle>& obstacles) const override;
  void append_poses(std::vector<MovingPose>& poses) const override;

  std::size_t size() const;
  PersonView person(std::size_t index) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mapbed
