#include "algorithms/scan_matching/turned_points.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

struct Turning {
  double c, s;                // of the turn
  double x, y;                // [cells] of the robot
  double moves_per_distance;  // what the turns of the group move a point to either side, at most
};

// Without the call that std::floor is where SSE4 may be missing.
MAPBED_INLINE_LOOP inline int floor_of(double x) {
  const int towards_zero = static_cast<int>(x);
  return towards_zero - (x < towards_zero ? 1 : 0);
}

// The first cell that each point falls into, and how many cells more it may be moved on.
void turn_into_cells(Processor processor, const FieldPoints& points,
                     const std::vector<double>& distances, const Turning& turning, int* x, int* y,
                     int* more) {
  const float* from_x = points.x.data();
  const float* from_y = points.y.data();
  const double* distance = distances.data();
  const std::size_t count = points.size();
  run(processor, [=]() MAPBED_INLINE_LOOP {
    for (std::size_t i = 0; i < count; ++i) {
      const double px = double{from_x[i]}, py = double{from_y[i]};
      const double moves = turning.moves_per_distance * distance[i];
      x[i] = floor_of(turning.c * px - turning.s * py + turning.x - moves);
      y[i] = floor_of(turning.s * px + turning.c * py + turning.y - moves);
      more[i] = -floor_of(-2.0 * moves);
    }
  });
}

}  // namespace

PointTurner::PointTurner(const FieldPoints& points, const Pose2& center, double resolution,
                         const BoundPyramid& pyramid, const SearchLattice& lattice, int most_bits,
                         Processor processor)
    : points_(points),
      pyramid_(pyramid),
      lattice_(lattice),
      processor_(processor),
      theta_(center.theta),
      x_(center.x / resolution),
      y_(center.y / resolution),
      distances_(points.size(), 0.0) {
  if (most_bits == 0) return;
  for (std::size_t i = 0; i < points.size(); ++i) {
    distances_[i] = std::hypot(double{points.x[i]}, double{points.y[i]});
  }
}

// The finest one that covers so many cells.
std::uint8_t PointTurner::level_over(int cells) const {
  int level = 0;
  while (level < static_cast<int>(pyramid_.levels.size()) && 1 << level < cells) ++level;
  return level < static_cast<int>(pyramid_.levels.size()) ? static_cast<std::uint8_t>(level)
                                                          : PointsInCells::kUnbounded;
}

TurnedPoints PointTurner::turned(const TurnGroup& group) const {
  const int last = (1 << group.bits) - 1;  // turn of the group, from the first
  const double theta = normalized_angle(theta_ + (group.first + 0.5 * last) * lattice_.turn_step);
  const Turning turning{std::cos(theta), std::sin(theta), x_, y_, 0.5 * last * lattice_.turn_step};
  TurnedPoints turned;
  std::vector<int>&x = turned.cells.x, &y = turned.cells.y;
  const std::size_t count = points_.size();
  x.resize(count);
  y.resize(count);
  std::vector<int> more(count);
  turn_into_cells(processor_, points_, distances_, turning, x.data(), y.data(), more.data());

  const int reach = lattice_.shifts + 1;
  const CellIndex low{pyramid_.box.min.x - reach, pyramid_.box.min.y - reach};
  const CellIndex high{pyramid_.box.max.x + reach, pyramid_.box.max.y + reach};
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool reachable = x[i] + more[i] >= low.x && x[i] <= high.x &&  //
                           y[i] + more[i] >= low.y && y[i] <= high.y;
    if (!reachable) continue;
    x[kept] = x[i];
    y[kept] = y[i];
    if (last > 0) turned.cells.level.push_back(level_over((1 << group.level) + more[i]));
    if (!points_.weights.empty()) turned.weights.push_back(points_.weights[i]);
    ++kept;
  }
  x.resize(kept);
  y.resize(kept);
  return turned;
}

}  // namespace mapbed
