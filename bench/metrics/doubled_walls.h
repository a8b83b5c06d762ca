#pragma once

#include "algorithms/grid/occupancy_map.h"
#include "core/config/option.h"
#include "worlds/geometry/raster.h"

namespace mapbed {

struct DoubledWallOptions {
  double occupied = 0.5;  // cells of at least this probability count as occupied
  double reach = 1.0;     // [m] along the normal to both sides
  int gap = 2;            // [cells] between two walls of the map, at least: less is one thick wall
};

template <class Visitor>
void visit_fields(DoubledWallOptions& o, Visitor&& visit) {
  visit("occupied", o.occupied, kFraction, "cells of at least this probability count as occupied");
  visit("reach", o.reach, Unit::meter, between(0.01, 100.0),
        "how far to both sides of a wall others count");
  visit("gap", o.gap, between(1, 1000), "cells between two walls of the map, at least");
}

// Walls that stand in a map twice, as they do where a robot came back without noticing.
//
// For each true wall cell, walls are counted along its normal, in a strip three cells wide: those
// of the map and those of the truth. Faces count, so both sides of a thin wall are in the truth, as
// are the frames of a door; true cells near which the map knows nothing are left out. So are cells
// at corners and of things too small to have a normal. The true map counts every gap, the map only
// such of `gap` cells: a face that is off by one cell makes no wall more.
struct DoubledWalls {
  int walls = 0;    // cells that were looked at
  int doubled = 0;  // of these, with more walls in the map than there are

  double fraction() const;  // NaN where nothing was looked at
};

DoubledWalls doubled_walls(const OccupancyMap& map, const TrueMap& truth,
                           const DoubledWallOptions& options = {});

}  // namespace mapbed
