#pragma once

#include "algorithms/visibility/batch_filter.h"
#include "core/config/option.h"

namespace mapbed {

struct EverFreeOptions {
  int scans = 10;
  bool same_scan = false;
  double sensor_margin = 0.2;  // [m]
  int pose_margin = 2;         // [cells]
  double resolution = 0.05;    // [m]
  BeamLimits beams{};
};

template <class Visitor>
void visit_fields(EverFreeOptions& o, Visitor&& visit) {
  visit("scans", o.scans, between(1, 1000),
        "one after the other that saw a place free, of those that looked there, after which "
        "whatever is ever seen there is dynamic");
  visit("same_scan", o.same_scan,
        "the places about it must be free in the very scan, not in as many that looked at each");
  visit("sensor_margin", o.sensor_margin, Unit::meter, kNotNegative,
        "before a hit, in which a place is not free: the laser's error");
  visit("pose_margin", o.pose_margin, between(0, 20),
        "cells about a place that must be free too: the error of poses");
  visit("resolution", o.resolution, Unit::meter, between(0.005, 10.0), "side of a cell");
  visit("beams", o.beams, "which beams are used, and how far");
}

// No vote but a proof: a place that was surely free cannot be of the place, and whatever is ever
// seen there is dynamic, before and after. In one scan a cell is free that beams run through, up to
// the first cell in which any of them met something or came within `sensor_margin` of it. Surely
// free it is after `scans` of these in a row, if all cells within `pose_margin` are as well: what
// nobody looked at is not, and glass, which sends back a beam now and then, hardly ever.
//
// Scans in a row and the cells about are those of Dynablox (Schmid et al., IEEE RA-L 2023), which
// judges while it goes; margins and judging in the end those of DUFOMap (Duberg et al., IEEE RA-L
// 2024), which is this with scans 1, same_scan, margins of 0.2 m and 1, cells of 0.1 m. A plane has
// few beams: with one scan alone its neighbours prove little far away, and too much at glass.
//
// It trusts the path within the margin for poses: where a loop stays open by more, a wall that is
// seen at two places was surely free at one of them.
//
// Doors that opened once and chairs that were taken away are dynamic too.
class EverFree : public BatchFilter {
 public:
  explicit EverFree(const EverFreeOptions& options = {}) : options_(options) {}

 private:
  BeamLabels labels(std::span<const LaserScan> scans,
                    const Trajectory& map_from_robot) const override;

  EverFreeOptions options_;
};

}  // namespace mapbed
