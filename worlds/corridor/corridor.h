#pragma once

#include <cstdint>

#include "core/config/option.h"
#include "worlds/world.h"

namespace mapbed {

// A straight corridor along x with rooms behind doors that open and close, door frames, a bin and a
// few things along the walls. The floor of the corridor reaches from (0, 0) to (length, width).
//
// Paths: `one_way` from the west end to the east end; `there_and_back` returns.
struct CorridorOptions {
  std::uint64_t seed = 0;   // 0: as said below; others vary sizes by up to 10 %
  double length = 25.0;     // [m] inside
  double width = 4.0;       // [m] inside
  double room_depth = 3.5;  // [m] of the rooms behind the doors
  int doors_a_side = 4;
  double clutter = 1.0;          // things along the walls: 0 the bin only, 1 as usual
  double door_mean_open = 8.0;   // [s]
  double door_mean_shut = 25.0;  // [s]
  int walkers = 4;
  int standing = 0;
  int blockers = 0;
};

template <class Visitor>
void visit_fields(CorridorOptions& o, Visitor&& visit) {
  visit("seed", o.seed, "0: the corridor as it is; another number: another one of its kind");
  visit("length", o.length, Unit::meter, between(8, 1000), "of the corridor, inside");
  visit("width", o.width, Unit::meter, between(1.8, 20), "of the corridor, inside");
  visit("room_depth", o.room_depth, Unit::meter, between(2, 20), "of the rooms behind the doors");
  visit("doors_a_side", o.doors_a_side, between(0, 200), "doors along either side");
  visit("clutter", o.clutter, between(0, 2), "how much stands along the walls; 1: as usual");
  visit("door_mean_open", o.door_mean_open, Unit::second, between(0.0, 1e6),
        "how long a door stays open; 0: until somebody needs it");
  visit("door_mean_shut", o.door_mean_shut, Unit::second, between(0.0, 1e6),
        "how long a door stays shut; 0: until somebody needs it");
  visit("walkers", o.walkers, between(0, 500), "people who walk about");
  visit("standing", o.standing, between(0, 500), "people who stand");
  visit("blockers", o.blockers, between(0, 100), "people who step in the robot's way on purpose");
}

// An office corridor with a route of 74 m, there and back.
inline CorridorOptions office_corridor() {
  return {.length = 40.0, .width = 2.4, .room_depth = 4.5, .doors_a_side = 8, .walkers = 10};
}

World build_corridor(const CorridorOptions& options);

}  // namespace mapbed
