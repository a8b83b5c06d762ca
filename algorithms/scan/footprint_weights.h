#pragma once

#include <vector>

#include "core/sensor/laser_scan.h"

namespace mapbed {

// How much each beam of a scan counts, in [0, 1], by the footprint that it has where it ends.
//
// A beam tells where a surface is only to within its share of the scan across: s = r * step /
// sqrt(12) for a uniform error at range r. Where the surface faces the beam that does not matter;
// aslant, and where no line tells how it lies, it moves the end off the surface, by s * |cos| of
// the angle between the beam and the line through the hits about its end. That error adds to
// `sigma` [m], of ends about the mapped surface, and the beam counts by sigma^2 over both together.
//
// Hits at `max_range` [m] or more count fully, as do lines through hits farther apart than
// `max_gap` [m] (see surface_points.h).
std::vector<float> footprint_weights(const LaserScan& scan, double max_range, double max_gap,
                                     double sigma);

}  // namespace mapbed
