#pragma once

#include "algorithms/grid/occupancy_map.h"
#include "algorithms/scan/beam.h"
#include "core/geometry/trajectory.h"
#include "core/labels/beam_labels.h"
#include "core/log/sensor_log.h"

namespace mapbed {

struct CauseMapOptions {
  double p_static = 0.9;     // p(c) of (4.4)
  double resolution = 0.05;  // [m] side of a cell
  double least_m = 1e-3;     // m_j is kept in [least_m, 1 - least_m]
  BeamLimits beams{};
};

// The EM of section 4.2 with the poses fixed: the map m and the expectations e of what made each
// beam, c = 1 for something static. All beams that end in one cell have the same expectation,
//
//   E-step (4.10)   e_j = p / (p + (1 - p) (1 / m_j - 1))
//   M-step (4.15)   m_j = n_j e_j / (n_j + x_j),
//
// with n_j beams that end in the cell and x_j the length of all that run through it without ending
// there, in cell sides, so that m does not depend on the resolution; alpha_j is n_j e_j, beta_j
// n_j (1 - e_j) + x_j. So a step takes time by the cells, and beams are walked along once. A cell
// that reflects the fraction r = n / (n + x) settles at max(0, (p r - (1 - p)) / (2 p - 1)): what
// reflects less often than (1 - p) / p fades.
class CauseMap {
 public:
  // Scans of level lasers, a pose for each, map_from_robot; all e = p, and the M-step for these.
  // Throws InputError where p_static is not above one half: then every cell that was ever seen
  // through would fade.
  CauseMap(const SensorLog& log, const Trajectory& map_from_robot, const CauseMapOptions& options);

  void step();  // E, then M

  // E[ln p(z, c | x, m)] of (4.7), (4.9) included; may fall from one step to the next.
  double expected_log_likelihood() const;
  // ln p(z | x, m): sum over hits of ln(p m + (1 - p)(1 - m)), and of x_j ln(1 - m_j) over all
  // beams. No step lowers it.
  double marginal_log_likelihood() const;

  // e of the beams of each scan, by the likeliest of the cells that they may have ended in: the one
  // that they do end in and those about it, for ranges and poses are no better known.
  BeamLabels labels(const SensorLog& log, const Trajectory& map_from_robot) const;
  OccupancyMap occupancy() const;  // m_j, of cells that a beam touched

 private:
  struct Cell {
    float passes = 0.0F;  // x_j [cell sides]
    float ends = 0.0F;    // n_j
    float e = 0.0F;       // of the beams that end here, that the M-step had
  };
  double m_of(const Cell& cell) const;
  double largest_m_about(CellIndex index) const;

  CauseMapOptions options_;
  TiledGrid<Cell> cells_;
};

}  // namespace mapbed
