#pragma once

#include <cstdint>

#include "core/config/option.h"
#include "worlds/world.h"

namespace mapbed {

// One floor of an office building, a twin of the Intel Research Lab in Seattle: a square corridor
// ring with rooms outside and inside of it, furniture, one meeting room behind glass. The origin is
// the south-west corner.
//
// Paths: `ring` once round the corridor; `tour` once round and once round with a visit to every
// open room; `long_tour` three rounds and two such visits; `tag_tour` four and three, 790 m.
struct OfficeOptions {
  std::uint64_t seed = 0;       // 0: as said below; others vary sizes by up to 10 %
  double size = 28.0;           // [m] of the square
  double corridor_width = 2.0;  // [m] between middle lines of walls
  double room_depth = 5.6;      // [m] of the outer rooms
  int rooms_a_side = 5;         // outer rooms, along the south and the north side
  int inner_rooms = 3;          // on either half of the block inside the ring
  double open_rooms = 0.75;     // fraction of the rooms that stand open
  double furniture = 1.0;       // how full: 0 none, 1 as usual
  bool glass_wall = true;
  int walkers = 0;
  int standing = 0;
  int tags = 0;
};

template <class Visitor>
void visit_fields(OfficeOptions& o, Visitor&& visit) {
  visit("seed", o.seed, "0: the office as it is; another number: another office of its kind");
  visit("size", o.size, Unit::meter, between(20, 200), "side of the square building");
  visit("corridor_width", o.corridor_width, Unit::meter, between(1.5, 6),
        "between the middle lines of its walls");
  visit("room_depth", o.room_depth, Unit::meter, between(3, 20), "of the outer rooms");
  visit("rooms_a_side", o.rooms_a_side, between(3, 30), "outer rooms along one side");
  visit("inner_rooms", o.inner_rooms, between(1, 20), "rooms on either half of the inner block");
  visit("open_rooms", o.open_rooms, kFraction, "fraction of the rooms that stand open");
  visit("furniture", o.furniture, between(0, 2), "how full the rooms are; 1: as usual");
  visit("glass_wall", o.glass_wall, "the meeting room stands behind a wall of glass");
  visit("walkers", o.walkers, between(0, 500), "people who walk about");
  visit("standing", o.standing, between(0, 500), "people who stand in the rooms");
  visit("tags", o.tags, between(0, 1000), "RFID tags on the walls of the corridor ring");
}

World build_office(const OfficeOptions& options);

}  // namespace mapbed
