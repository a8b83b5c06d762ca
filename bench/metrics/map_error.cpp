#include "bench/metrics/map_error.h"

#include <cmath>
#include <limits>

#include "core/check.h"

namespace mapbed {
namespace {

double share(int part, int whole) {
  if (whole == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(part) / static_cast<double>(whole);
}

bool is_solid(TrueCell cell) {
  return cell == TrueCell::occupied || cell == TrueCell::interior;
}

// The true map by points of the world; its cells need not lie on those of the other map.
class Lookup {
 public:
  Lookup(const OccupancyMap& map, const TrueMap& truth, const MapErrorOptions& options)
      : map_(map), truth_(truth), options_(options) {}

  bool truth_is_solid_near(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d cell = (point - truth_.origin) / truth_.resolution;
    const auto x = static_cast<int>(std::floor(cell.x()));
    const auto y = static_cast<int>(std::floor(cell.y()));
    return any_near(x, y, [this](int i, int j) {
      return i >= 0 && j >= 0 && i < truth_.width && j < truth_.height && is_solid(truth_.at(i, j));
    });
  }
  bool map_is_occupied_near(const Eigen::Vector2d& point) const {
    const CellIndex cell = map_.cell_of(point);
    return any_near(cell.x, cell.y, [this](int i, int j) {
      return map_[{i, j}].known() && map_[{i, j}].probability >= options_.occupied;
    });
  }
  bool map_knows_near(const Eigen::Vector2d& point) const {
    const CellIndex cell = map_.cell_of(point);
    return any_near(cell.x, cell.y, [this](int i, int j) { return map_[{i, j}].known(); });
  }

 private:
  template <class Predicate>
  bool any_near(int x, int y, Predicate&& holds) const {
    for (int j = y - options_.tolerance; j <= y + options_.tolerance; ++j) {
      for (int i = x - options_.tolerance; i <= x + options_.tolerance; ++i) {
        if (holds(i, j)) return true;
      }
    }
    return false;
  }

  const OccupancyMap& map_;
  const TrueMap& truth_;
  const MapErrorOptions& options_;
};

Eigen::Vector2d center_of(const TrueMap& truth, int x, int y) {
  return truth.origin + truth.resolution * Eigen::Vector2d(x + 0.5, y + 0.5);
}

}  // namespace

double MapErrors::precision() const {
  return share(right, occupied);
}

double MapErrors::recall() const {
  return share(found, true_occupied);
}

double MapErrors::f1() const {
  const double p = precision();
  const double r = recall();
  return p + r > 0.0 ? 2.0 * p * r / (p + r) : p + r;  // 0, or NaN
}

double MapConfusion::coverage() const {
  return share(truly_free.known(), truly_free.known() + truly_free.unknown);
}

double MapConfusion::free_as_occupied() const {
  return share(truly_free.occupied, truly_free.known());
}

double MapConfusion::occupied_as_free() const {
  return share(truly_occupied.free, truly_occupied.known());
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
  const Lookup look(map, truth, options);
  MapErrors errors;
  map.for_each([&](CellIndex cell, const Occupancy& value) {
    if (!value.known() || value.probability < options.occupied) return;
    ++errors.occupied;
    if (look.truth_is_solid_near(map.center_of(cell))) ++errors.right;
  });
  for (int y = 0; y < truth.height; ++y) {
    for (int x = 0; x < truth.width; ++x) {
      if (truth.at(x, y) != TrueCell::occupied) continue;
      const Eigen::Vector2d center = center_of(truth, x, y);
      if (!look.map_knows_near(center)) continue;
      ++errors.true_occupied;
      if (look.map_is_occupied_near(center)) ++errors.found;
    }
  }
  return errors;
}

}  // namespace mapbed
