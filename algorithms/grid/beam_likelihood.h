#pragma once

#include "algorithms/grid/occupancy_map.h"
#include "algorithms/scan/beam.h"
#include "core/config/option.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

// How a map of the fraction of beams that each cell reflects, m_j of (2.14), explains a beam.
struct BeamLikelihoodOptions {
  // A cell counts with the length x_j of the beam in it, in cell sides: prod (1 - m_j)^x_j, section
  // 4.2. Without it each covered cell counts once, as (2.14) is printed, and a slanting beam, which
  // covers more cells, is less likely than one along an axis.
  bool length_weighted = true;
  double unknown = 0.5;   // m_j of a cell of which nothing is known
  double least_m = 1e-3;  // m_j is kept in [least_m, 1 - least_m]: no beam is impossible
  BeamLimits beams{};
};

template <class Visitor>
void visit_fields(BeamLikelihoodOptions& o, Visitor&& visit) {
  visit("length_weighted", o.length_weighted,
        "a cell counts with the length of the beam in it, and not just once");
  visit("unknown", o.unknown, kFraction, "fraction of beams that an unknown cell reflects");
  visit("least_m", o.least_m, between(1e-12, 0.5),
        "a cell reflects at least this fraction of beams, and lets at least this fraction through");
  visit("beams", o.beams, "which beams are used, and how far");
}

// What a map says about one beam; the factors of (2.14), (4.1) and (4.7).
struct BeamTerms {
  double log_path = 0.0;  // sum of x_j ln(1 - m_j) over the cells before the one it ends in
  double m_end = 0.0;     // of the cell it ends in; means nothing for a beam that hit nothing
};

BeamTerms beam_terms(const Beam& beam, const OccupancyMap& map,
                     const BeamLikelihoodOptions& options = {});

// ln p(z | x, m), (2.14): the path is free and, unless zeta = 1, the end reflects.
double log_likelihood(const Beam& beam, const OccupancyMap& map,
                      const BeamLikelihoodOptions& options = {});

// The same of a scan, whose beams are independent; failed beams say nothing.
double log_likelihood(const LaserScan& scan, const Pose2& map_from_robot, const OccupancyMap& map,
                      const BeamLikelihoodOptions& options = {});

// The fast approximation of a scan by the end points of its hits alone, section 2.2.4: the sum of
// field.log_at(end point). Beams that hit nothing say nothing.
template <class Field>
double end_point_log_likelihood(const LaserScan& scan, const Pose2& map_from_robot,
                                const Field& field, const BeamLimits& limits = {}) {
  double sum = 0.0;
  for_each_beam(scan, map_from_robot, limits, [&](std::size_t, const Beam& beam) {
    if (beam.hit) sum += field.log_at(beam.end);
  });
  return sum;
}

}  // namespace mapbed
