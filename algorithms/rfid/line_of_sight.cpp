#include "algorithms/rfid/line_of_sight.h"

#include <cmath>

#include "algorithms/grid/traversal.h"
#include "algorithms/localization/free_space.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

// [m] along a beam until it has met something occupied.
double range_of(const OccupancyMap& map, const Eigen::Vector2d& from, double bearing,
                double reach) {
  const Eigen::Vector2d end = from + reach * Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
  double passed = 0.0, met = reach;
  bool is_open = true;
  const auto look = [&](CellIndex cell, double length) {
    if (is_open && is_occupied(map[cell])) {
      met = passed;
      is_open = false;
    }
    passed += length;
  };
  const CoveredCell last = traverse(from, end, map.frame(), look);
  look(last.cell, last.length);
  return met;
}

}  // namespace

LineOfSight::LineOfSight(const OccupancyMap& map, const Eigen::Vector2d& from, double reach)
    : from_(from) {
  for (int i = 0; i < kBearings; ++i) {
    const double bearing = 2.0 * kPi * i / kBearings - kPi;
    const double range = range_of(map, from, bearing, reach) + kThickness;
    squares_.push_back(static_cast<float>(range * range));
  }
}

bool LineOfSight::sees(float x, float y) const {
  const float dx = x - static_cast<float>(from_.x()), dy = y - static_cast<float>(from_.y());
  const float turn = std::atan2(dy, dx) * static_cast<float>(kBearings / (2.0 * kPi));
  const int bearing = static_cast<int>(std::lround(turn)) + kBearings / 2;
  return dx * dx + dy * dy <= squares_[static_cast<std::size_t>(bearing % kBearings)];
}

}  // namespace mapbed
