#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "algorithms/people/front_end/scan_view.h"
#include "core/config/option.h"

namespace mapbed {

struct LegFeatureOptions {
  double radius = 0.07;         // [m]
  double jump = 0.15;           // [m]
  double in_front = 0.15;       // [m]
  double least_width = 0.04;    // [m]
  double widest_leg = 0.24;     // [m]
  double widest_pair = 0.5;     // [m]
  double max_range = 16.0;      // [m]
  double widest_spacing = 0.3;  // [m]
};

template <class Visitor>
void visit_fields(LegFeatureOptions& o, Visitor&& visit) {
  visit("radius", o.radius, Unit::meter, between(0.01, 0.5), "of a leg");
  visit("jump", o.jump, Unit::meter, between(0.01, 2.0),
        "between neighbouring ranges, at which one thing ends and another begins");
  visit("in_front", o.in_front, Unit::meter, between(0.01, 5.0),
        "by how much a leg stands in front of what is beside it");
  visit("least_width", o.least_width, Unit::meter, between(0.0, 1.0),
        "of a leg, up to the spacing of beams");
  visit("widest_leg", o.widest_leg, Unit::meter, between(0.01, 1.0), "of one leg");
  visit("widest_pair", o.widest_pair, Unit::meter, between(0.01, 2.0),
        "of two legs that are seen as one thing");
  visit("max_range", o.max_range, Unit::meter, between(0.1, 200.0), "where no leg is looked for");
  visit("widest_spacing", o.widest_spacing, Unit::meter, between(0.001, 10.0),
        "of neighbouring beams at the range of a leg; farther off, beams miss it too often");
}

// Something in a scan that may be a leg, or two legs seen as one.
struct LegFeature {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m] its axis, in the robot frame
  double range = 0.0;                                  // [m] of the axis, from the laser
  double width = 0.0;                                  // [m] between its outermost hits
  double spacing = 0.0;                                // [m] of neighbouring beams there
  double quality = 0.0;                                // in (0, 1]: how much it looks like a leg
  std::size_t first = 0;                               // beams of the scan that met it: from here
  std::size_t last = 0;                                // to here, both included
  bool is_wide = false;                                // two legs, rather
};

// Section 3.2.3: legs are local minima of the range profile. Hits of neighbouring beams that follow
// each other without a jump are one thing; it may be a leg if its width fits, and it stands in
// front of what is beside it. One side may be hidden by something nearer, or lie outside of the
// view: that looks less like a leg. A wall seen aslant, whose ranges jump from beam to beam, is
// told by 1 / r, which is linear in the bearing along a line. With beams far apart a leg is one
// beam or two.
std::vector<LegFeature> leg_features(const ScanView& view, const LegFeatureOptions& options);

}  // namespace mapbed
