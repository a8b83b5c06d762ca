#pragma once

#include <cstdint>

#include "core/config/option.h"
#include "worlds/world.h"

namespace mapbed {

// One large hall of a museum: columns as thin as legs and thicker ones, showcases of glass, statues
// behind ropes, free-standing walls, and niches between the piers of the long walls. Visitors walk
// along the lanes of a grid and stand before the showcases. The hall reaches from (0, 0) to
// (width, length), inside.
//
// Paths: `tour_with_one_loop` along four lanes, back to its start and a little on, a drive of 57 m
// as in chapters 3 and 4; `long_tour` past everything.
struct MuseumOptions {
  std::uint64_t seed = 0;  // 0: as said below; others vary sizes by up to 10 %
  double width = 30.0;     // [m] along x, inside
  double length = 45.0;    // [m] along y, inside
  double exhibits = 0.85;  // fraction of the fields of the grid that hold something
  int walkers = 12;
  int standing = 3;
  int blockers = 0;
};

template <class Visitor>
void visit_fields(MuseumOptions& o, Visitor&& visit) {
  visit("seed", o.seed, "0: the museum as it is; another number: another one of its kind");
  visit("width", o.width, Unit::meter, between(20, 300), "of the hall along x, inside");
  visit("length", o.length, Unit::meter, between(25, 300), "of the hall along y, inside");
  visit("exhibits", o.exhibits, kFraction, "fraction of the hall's fields that hold something");
  visit("walkers", o.walkers, between(0, 500), "visitors who walk about");
  visit("standing", o.standing, between(0, 500), "visitors who stand before the showcases");
  visit("blockers", o.blockers, between(0, 100), "people who step in the robot's way on purpose");
}

World build_museum(const MuseumOptions& options);

}  // namespace mapbed
