#include "algorithms/scan_matching/search_lattice.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/geometry/angle.h"
#include "core/input_error.h"
#include "core/statistics/quantile.h"

namespace mapbed {
namespace {

constexpr double kMostTurns = 10'000;  // to either side

}  // namespace

SearchLattice lattice_of(const FieldPoints& points, double resolution,
                         const CorrelativeMatcherOptions& options) {
  SearchLattice lattice;
  lattice.shifts = static_cast<int>(std::ceil(options.window / resolution - 1e-9));
  lattice.turn_step = options.turn_step;
  if (lattice.turn_step <= 0.0) {
    std::vector<float> distances(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      distances[i] = std::hypot(points.x[i], points.y[i]);
    }
    lattice.turn_step = 1.0 / std::max(1.0, double{quantile_of(std::move(distances), 0.9)});
  }
  const double turns = std::ceil(options.turn_window / lattice.turn_step - 1e-9);
  if (!(turns <= kMostTurns)) {
    throw InputError(
        fmt::format("a search over {:g} rad in turns of {:g} rad tries too many of them; "
                    "choose a larger turn_step or a smaller turn_window",
                    options.turn_window, lattice.turn_step));
  }
  lattice.turns = static_cast<int>(turns);
  return lattice;
}

Pose2 SearchLattice::pose(const Pose2& center, double resolution, int turn, int x, int y) const {
  return {center.x + x * resolution, center.y + y * resolution,
          normalized_angle(center.theta + turn * turn_step)};
}

}  // namespace mapbed
