#include "algorithms/dynamic_em/cause_map.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "algorithms/dynamic_em/beam_expectation.h"
#include "algorithms/grid/cells_about.h"
#include "algorithms/grid/traversal.h"
#include "algorithms/scan/scans_on_path.h"
#include "core/input_error.h"

namespace mapbed {

CauseMap::CauseMap(const SensorLog& log, const Trajectory& map_from_robot,
                   const CauseMapOptions& options)
    : options_(options), cells_(GridFrame{.resolution = options.resolution}) {
  if (!(options.p_static > 0.5 && options.p_static < 1.0)) {
    throw InputError({}, fmt::format("p_static {} is not between 0.5 and 1", options.p_static),
                     "at 0.5 or less every place that a beam ever passed would fade");
  }
  TiledGrid<Cell>::Writer writer(cells_);
  for_each_scan_on_path(log, map_from_robot, [&](const LaserScan& scan, const Pose2& pose) {
    for_each_beam(scan, pose, options_.beams, [&](std::size_t, const Beam& beam) {
      const double sides = 1.0 / cells_.resolution();
      const auto pass = [&](CellIndex cell, double length) {
        writer.at(cell).passes += static_cast<float>(length * sides);
      };
      const CoveredCell last = traverse(beam.start, beam.end, cells_.frame(), pass);
      if (!beam.hit) return;
      Cell& cell = writer.at(last.cell);
      cell.ends += 1.0F;
      cell.e = static_cast<float>(options_.p_static);
    });
  });
}

double CauseMap::m_of(const Cell& cell) const {
  const double touched = static_cast<double>(cell.ends) + static_cast<double>(cell.passes);
  const double m = static_cast<double>(cell.ends) * static_cast<double>(cell.e) / touched;
  return std::clamp(m, options_.least_m, 1.0 - options_.least_m);
}

double CauseMap::largest_m_about(CellIndex index) const {
  return largest_about(index, [&](CellIndex about) {
    const Cell& cell = cells_[about];
    return cell.ends > 0.0F ? m_of(cell) : options_.least_m;
  });
}

void CauseMap::step() {
  TiledGrid<Cell>::Writer writer(cells_);
  cells_.for_each([&](CellIndex index, const Cell& cell) {
    if (cell.ends == 0.0F) return;
    const BeamTerms terms{.m_end = m_of(cell)};
    writer.at(index).e = static_cast<float>(expectation_of_cause(terms, true, options_.p_static));
  });
}

double CauseMap::expected_log_likelihood() const {
  double sum = 0.0;
  cells_.for_each([&](CellIndex, const Cell& cell) {
    if (cell.ends + cell.passes == 0.0F) return;
    const BeamTerms terms{.m_end = m_of(cell)};
    sum += static_cast<double>(cell.passes) * std::log1p(-terms.m_end);
    if (cell.ends == 0.0F) return;
    const auto e = static_cast<double>(cell.e);
    sum += static_cast<double>(cell.ends) * (mapbed::expected_log_likelihood(terms, true, e) +
                                             expected_log_prior(e, options_.p_static));
  });
  return sum;
}

double CauseMap::marginal_log_likelihood() const {
  const double p = options_.p_static;
  double sum = 0.0;
  cells_.for_each([&](CellIndex, const Cell& cell) {
    if (cell.ends + cell.passes == 0.0F) return;
    const double m = m_of(cell);
    sum += static_cast<double>(cell.passes) * std::log1p(-m);
    sum += static_cast<double>(cell.ends) * std::log(p * m + (1.0 - p) * (1.0 - m));
  });
  return sum;
}

BeamLabels CauseMap::labels(const SensorLog& log, const Trajectory& map_from_robot) const {
  BeamLabels labels;
  for_each_scan_on_path(log, map_from_robot, [&](const LaserScan& scan, const Pose2& pose) {
    ScanLabels& of_scan = labels.emplace_back(unlabelled(scan));
    for_each_beam(scan, pose, options_.beams, [&](std::size_t n, const Beam& beam) {
      if (!beam.hit) return;
      const BeamTerms terms{.m_end = largest_m_about(cells_.cell_of(beam.end))};
      of_scan.static_probability[n] =
          static_cast<float>(expectation_of_cause(terms, true, options_.p_static));
    });
  });
  return labels;
}

OccupancyMap CauseMap::occupancy() const {
  return occupancy_of(cells_, [&](const Cell& cell) {
    return cell.ends + cell.passes > 0.0F ? known(m_of(cell)) : Occupancy{};
  });
}

}  // namespace mapbed
