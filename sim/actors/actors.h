#pragma once

#include <memory>
#include <vector>

#include "core/random.h"
#include "sim/actors/actor.h"
#include "sim/actors/crowd_options.h"
#include "sim/actors/navigation_map.h"
#include "worlds/world.h"

namespace mapbed {

// Options of the groups, each below its own name.
struct ActorOptions {
  CrowdOptions people = {};
};

template <class Visitor>
void visit_fields(ActorOptions& o, Visitor&& visit) {
  visit("people", o.people, "who is about");
}

// All groups of a world, in the order in which they step. `walkable` is where people can walk,
// `robot` the circle around the robot at its start. Throws InputError where one does not fit.
std::vector<std::unique_ptr<Actor>> make_actors(const World& world, const NavigationMap& walkable,
                                                const Obstacle& robot, const ActorOptions& options,
                                                const Rng& rng);

}  // namespace mapbed
