#include "algorithms/grid/beam_likelihood.h"

#include <algorithm>
#include <cmath>

#include "algorithms/grid/traversal.h"

namespace mapbed {
namespace {

double m_of(const Occupancy& cell, const BeamLikelihoodOptions& options) {
  const double m = cell.known() ? static_cast<double>(cell.probability) : options.unknown;
  return std::clamp(m, options.least_m, 1.0 - options.least_m);
}

}  // namespace

BeamTerms beam_terms(const Beam& beam, const OccupancyMap& map,
                     const BeamLikelihoodOptions& options) {
  const double sides_per_metre = 1.0 / map.resolution();
  double log_path = 0.0;
  const CoveredCell last =
      traverse(beam.start, beam.end, map.frame(), [&](CellIndex cell, double length) {
        const double x = options.length_weighted ? length * sides_per_metre : 1.0;
        log_path += x * std::log(1.0 - m_of(map[cell], options));
      });
  return {log_path, m_of(map[last.cell], options)};
}

double log_likelihood(const Beam& beam, const OccupancyMap& map,
                      const BeamLikelihoodOptions& options) {
  const BeamTerms terms = beam_terms(beam, map, options);
  return terms.log_path + (beam.hit ? std::log(terms.m_end) : 0.0);
}

double log_likelihood(const LaserScan& scan, const Pose2& map_from_robot, const OccupancyMap& map,
                      const BeamLikelihoodOptions& options) {
  double sum = 0.0;
  for_each_beam(scan, map_from_robot, options.beams,
                [&](std::size_t, const Beam& beam) { sum += log_likelihood(beam, map, options); });
  return sum;
}

}  // namespace mapbed
