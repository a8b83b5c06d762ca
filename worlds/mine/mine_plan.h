#pragma once

#include <cstdint>

#include "core/config/option.h"
#include "worlds/world.h"

namespace mapbed {

// The plan of a mine on level ground: two long haulage ways side by side, crosscuts between them, a
// third way that leaves and comes back, and short side cuts without an end. Walls are rough and no
// way is quite straight.
//
// Paths: `large_loop` out by one haulage way and back by the other, and a bit on; `tour` the same
// and then round the smaller loops.
struct MinePlanOptions {
  std::uint64_t seed = 0;        // 0: as said below; others vary sizes by up to 10 %
  double length = 250.0;         // [m] along x
  double corridor_width = 3.2;   // [m] in the mean
  double roughness = 0.15;       // [m] sigma of the walls about smooth ones
  double bends = 1.2;            // [m] sigma of how far the ways stray from straight ones
  double side_cut_every = 30.0;  // [m] of way; 0: there are none
};

template <class Visitor>
void visit_fields(MinePlanOptions& o, Visitor&& visit) {
  visit("seed", o.seed, "0: the mine as it is; another number: another one of its kind");
  visit("length", o.length, Unit::meter, between(100, 2000), "along the haulage ways");
  visit("corridor_width", o.corridor_width, Unit::meter, between(2.4, 8), "in the mean");
  visit("roughness", o.roughness, Unit::meter, between(0, 0.3), "sigma of the walls");
  visit("bends", o.bends, Unit::meter, between(0, 2), "sigma of the ways about straight ones");
  visit("side_cut_every", o.side_cut_every, Unit::meter, between(0, 2000),
        "of way from one side cut to the next; 0: there are none");
}

World build_mine_plan(const MinePlanOptions& options);

}  // namespace mapbed
