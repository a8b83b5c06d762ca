#include "bench/metrics/map_error.h"

#include <limits>

#include "bench/metrics/near_cells.h"

namespace mapbed {
namespace {

double fraction(int part, int whole) {
  if (whole == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(part) / static_cast<double>(whole);
}

bool is_solid(TrueCell cell) {
  return cell == TrueCell::occupied || cell == TrueCell::interior;
}

Eigen::Vector2d center_of(const TrueMap& truth, int x, int y) {
  return truth.origin + truth.resolution * Eigen::Vector2d(x + 0.5, y + 0.5);
}

// True cells with a solid one within the tolerance, around the true map too.
NearCells near_solid(const TrueMap& truth, int tolerance) {
  const CellBox box{{-tolerance, -tolerance},
                    {truth.width - 1 + tolerance, truth.height - 1 + tolerance}};
  const CellBox inside{{0, 0}, {truth.width - 1, truth.height - 1}};
  return {box, tolerance, [&](CellIndex cell) {
            return inside.contains(cell) && is_solid(truth.at(cell.x, cell.y));
          }};
}

}  // namespace

double MapErrors::precision() const {
  return fraction(right, occupied);
}

double MapErrors::recall() const {
  return fraction(found, true_occupied);
}

double MapErrors::f1() const {
  const double p = precision();
  const double r = recall();
  return p + r > 0.0 ? 2.0 * p * r / (p + r) : p + r;  // 0, or NaN
}

double MapConfusion::coverage() const {
  return fraction(truly_free.known(), truly_free.known() + truly_free.unknown);
}

double MapConfusion::free_as_occupied() const {
  return fraction(truly_free.occupied, truly_free.known());
}

double MapConfusion::occupied_as_free() const {
  return fraction(truly_occupied.free, truly_occupied.known());
}

MapConfusion confusion_of(const OccupancyMap& map, const TrueMap& truth,
                          const MapErrorOptions& options) {
  MapConfusion confusion;
  for (int y = 0; y < truth.height; ++y) {
    for (int x = 0; x < truth.width; ++x) {
      const TrueCell is = truth.at(x, y);
      if (is != TrueCell::free && is != TrueCell::occupied) continue;
      MapSays& says = is == TrueCell::free ? confusion.truly_free : confusion.truly_occupied;
      const Occupancy& cell = map[map.cell_of(center_of(truth, x, y))];
      if (!cell.known()) {
        ++says.unknown;
      } else {
        ++(cell.probability >= options.occupied ? says.occupied : says.free);
      }
    }
  }
  return confusion;
}

MapErrors compare_maps(const OccupancyMap& map, const TrueMap& truth,
                       const MapErrorOptions& options) {
  const auto is_occupied = [&](const Occupancy& cell) {
    return cell.known() && cell.probability >= options.occupied;
  };
  const NearCells solid = near_solid(truth, options.tolerance);
  const GridFrame true_cells{.resolution = truth.resolution, .origin = truth.origin};
  MapErrors errors;
  map.for_each([&](CellIndex cell, const Occupancy& value) {
    if (!is_occupied(value)) return;
    ++errors.occupied;
    if (solid[true_cells.cell_of(map.center_of(cell))]) ++errors.right;
  });
  const CellBox box = cells_under(truth, map);
  const NearCells known(box, options.tolerance, [&](CellIndex cell) { return map[cell].known(); });
  const NearCells occupied(box, options.tolerance,
                           [&](CellIndex cell) { return is_occupied(map[cell]); });
  for (int y = 0; y < truth.height; ++y) {
    for (int x = 0; x < truth.width; ++x) {
      if (truth.at(x, y) != TrueCell::occupied) continue;
      const CellIndex cell = map.cell_of(center_of(truth, x, y));
      if (!known[cell]) continue;
      ++errors.true_occupied;
      if (occupied[cell]) ++errors.found;
    }
  }
  return errors;
}

}  // namespace mapbed
