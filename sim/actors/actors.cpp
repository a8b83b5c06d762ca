#include "sim/actors/actors.h"

#include "sim/actors/crowd.h"
#include "sim/actors/doors.h"
#include "sim/actors/movables.h"

namespace mapbed {
namespace {

struct Setting {
  const World& world;
  const NavigationMap& walkable;
  const Obstacle& robot;
  const ActorOptions& options;
  int first_entity;  // id of the first entity that the group adds
  Rng rng;
};

using Group = std::unique_ptr<Actor>;

struct ActorKind {
  const char* name;  // of the group's stream of chance
  Group (*make)(const Setting&);
};

// Doors move first, then chairs and the like, then people walk among them.
const ActorKind kKinds[] = {
    {"doors", [](const Setting& s) -> Group { return std::make_unique<Doors>(s.world, s.rng); }},
    {"movables",
     [](const Setting& s) -> Group {
       return std::make_unique<Movables>(s.world, s.first_entity, s.rng);
     }},
    {"people",
     [](const Setting& s) -> Group {
       return std::make_unique<Crowd>(s.world, s.walkable, s.robot, s.options.people,
                                      s.first_entity, s.rng);
     }},
};

}  // namespace

std::vector<std::unique_ptr<Actor>> make_actors(const World& world, const NavigationMap& walkable,
                                                const Obstacle& robot, const ActorOptions& options,
                                                const Rng& rng) {
  std::vector<Group> actors;
  std::size_t next_entity = world.entities.size();
  for (const ActorKind& kind : kKinds) {
    actors.push_back(kind.make(
        {world, walkable, robot, options, static_cast<int>(next_entity), rng.stream(kind.name)}));
    next_entity += actors.back()->entities().size();
  }
  return actors;
}

}  // namespace mapbed
