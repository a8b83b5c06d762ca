#pragma once

#include <cstdint>

#include "core/config/option.h"
#include "worlds/world.h"

namespace mapbed {

// A corridor that comes back to itself, about a block that nobody can see through; with a second,
// small loop beside it where `small_length` is not 0: the west corridor is then common to both.
// Shut doors, piers and a few things along the walls are all that tells one place from another.
//
// Paths: `once` round the large loop; `rounds` as often as said below, round the small loop where
// there is one and then once round the large one, and on by a part of a large round.
struct LoopCorridorOptions {
  std::uint64_t seed = 0;       // 0: as said below; others vary sizes by up to 10 %
  double length = 50.0;         // [m] of the large loop along x, outside
  double width = 12.0;          // [m] of the large loop along y, outside
  double corridor_width = 2.2;  // [m]
  double small_length = 0.0;    // [m] of the small loop along x, outside; 0: none
  double small_width = 12.0;    // [m] of the small loop along y, outside
  double features = 1.0;        // doors, piers and furniture: 0 bare walls, 1 as usual
  int rounds = 3;
  double last_round = 0.0;  // fraction of one more large round at the end of `rounds`
  int walkers = 0;
};

template <class Visitor>
void visit_fields(LoopCorridorOptions& o, Visitor&& visit) {
  visit("seed", o.seed, "0: the loop as it is; another number: another one of its kind");
  visit("length", o.length, Unit::meter, between(8, 1000), "of the large loop, outside");
  visit("width", o.width, Unit::meter, between(8, 1000), "of the large loop, outside");
  visit("corridor_width", o.corridor_width, Unit::meter, between(1.5, 10), "of the corridor");
  visit("small_length", o.small_length, Unit::meter, between(0, 1000),
        "of the small loop beside the large one; 0: there is none");
  visit("small_width", o.small_width, Unit::meter, between(6, 1000), "of the small loop");
  visit("features", o.features, between(0, 2), "doors, piers, furniture; 0: bare walls");
  visit("rounds", o.rounds, between(1, 100), "of the path `rounds`");
  visit("last_round", o.last_round, kFraction, "of one more large round, at the end of `rounds`");
  visit("walkers", o.walkers, between(0, 500), "people who walk about");
}

// 32 m x 10 m; `rounds` is a drive of 251 m, corners cut (Figure 5.10).
inline LoopCorridorOptions hall_loop() {
  return {
      .length = 32.0, .width = 10.0, .corridor_width = 2.8, .features = 0.7, .last_round = 0.47};
}
inline LoopCorridorOptions nested_loops() {
  return {.length = 46.0, .width = 30.0, .small_length = 16.0, .small_width = 12.0};
}

World build_loop_corridor(const LoopCorridorOptions& options);

}  // namespace mapbed
