#pragma once

#include "algorithms/grid/occupancy_map.h"
#include "worlds/geometry/raster.h"

namespace mapbed {

struct MapErrorOptions {
  double occupied = 0.5;  // cells of at least this probability count as occupied
  int tolerance = 1;      // [cells] by which a wall may be off, in x and y
};

// Occupied cells of a map in the world frame against the world's own. Only true cells near which
// the map knows anything count: what the robot never saw says nothing about its map.
struct MapErrors {
  int occupied = 0;       // cells of the map
  int right = 0;          // of these, with a true occupied cell within the tolerance
  int true_occupied = 0;  // cells of the truth, near which the map knows something
  int found = 0;          // of these, with an occupied cell of the map within the tolerance

  int spurious() const { return occupied - right; }
  double precision() const;  // NaN where there is nothing to count, as the others
  double recall() const;
  double f1() const;
};

// What the map says of cells that truly are of one kind.
struct MapSays {
  int free = 0;
  int occupied = 0;
  int unknown = 0;

  int known() const { return free + occupied; }
};

// Cell by cell, without tolerance. The inside of things, and what nobody gets to see, is left out.
struct MapConfusion {
  MapSays truly_free;
  MapSays truly_occupied;

  double coverage() const;  // fraction of the truly free cells that the map knows; NaN: none
  double free_as_occupied() const;  // fraction of the known truly free cells, as the next
  double occupied_as_free() const;
};

MapConfusion confusion_of(const OccupancyMap& map, const TrueMap& truth,
                          const MapErrorOptions& options = {});

MapErrors compare_maps(const OccupancyMap& map, const TrueMap& truth,
                       const MapErrorOptions& options = {});

}  // namespace mapbed
