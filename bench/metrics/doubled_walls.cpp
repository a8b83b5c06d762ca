#include "bench/metrics/doubled_walls.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <vector>

#include "bench/metrics/near_cells.h"

namespace mapbed {
namespace {

constexpr double kNeighbourhood = 0.25;  // [m] of wall to both sides that gives the normal
constexpr double kFlat = 0.15;           // variance across over variance along a straight wall

bool is_wall(const TrueMap& truth, int x, int y) {
  return x >= 0 && y >= 0 && x < truth.width && y < truth.height &&
         truth.at(x, y) == TrueCell::occupied;
}

// The wall cells about one cell that hang together with it, as offsets.
std::vector<CellIndex> wall_about(const TrueMap& truth, int x, int y, int radius) {
  const int side = 2 * radius + 1;
  std::vector<bool> seen(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  std::vector<CellIndex> cells;
  const auto visit = [&](int i, int j) {
    if (std::max(std::abs(i), std::abs(j)) > radius || !is_wall(truth, x + i, y + j)) return;
    const auto at = static_cast<std::size_t>((j + radius) * side + i + radius);
    if (seen[at]) return;
    seen[at] = true;
    cells.push_back({i, j});
  };
  visit(0, 0);
  for (std::size_t next = 0; next < cells.size(); ++next) {
    const CellIndex cell = cells[next];
    for (int j = -1; j <= 1; ++j) {
      for (int i = -1; i <= 1; ++i) visit(cell.x + i, cell.y + j);
    }
  }
  return cells;
}

// Across the line through the wall's cells; none where they are no line.
std::optional<Eigen::Vector2d> normal_at(const TrueMap& truth, int x, int y) {
  const int radius = std::max(3, static_cast<int>(std::lround(kNeighbourhood / truth.resolution)));
  const std::vector<CellIndex> cells = wall_about(truth, x, y, radius);
  if (static_cast<int>(cells.size()) <= radius) return {};
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const CellIndex cell : cells) mean += Eigen::Vector2d(cell.x, cell.y);
  mean /= static_cast<double>(cells.size());
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const CellIndex cell : cells) {
    const Eigen::Vector2d d = Eigen::Vector2d(cell.x, cell.y) - mean;
    scatter += d * d.transpose();
  }
  // Closed form of the eigenvalues h +- r, and the direction of the larger one.
  const double h = 0.5 * scatter.trace();
  const double r = std::hypot(0.5 * (scatter(0, 0) - scatter(1, 1)), scatter(0, 1));
  if (h - r > kFlat * (h + r)) return {};
  const double along = 0.5 * std::atan2(2.0 * scatter(0, 1), scatter(0, 0) - scatter(1, 1));
  return Eigen::Vector2d(-std::sin(along), std::cos(along));
}

// Walls that a strip through `center` meets, seen in steps of half a cell.
template <class IsWall>
int count_walls(const Eigen::Vector2d& center, const Eigen::Vector2d& normal, double resolution,
                double reach, int gap, IsWall&& is_wall_at) {
  const Eigen::Vector2d step = 0.5 * resolution * normal;
  const Eigen::Vector2d aside(-step.y(), step.x());
  const int steps = static_cast<int>(std::floor(2.0 * reach / resolution));
  int walls = 0;
  int open = 2 * gap;  // half cells since the last wall
  for (int i = -steps; i <= steps; ++i, ++open) {
    bool hit = false;
    for (int k = -2; k <= 2 && !hit; ++k) hit = is_wall_at(center + i * step + k * aside);
    if (!hit) continue;
    if (open >= 2 * gap) ++walls;
    open = -1;
  }
  return walls;
}

}  // namespace

double DoubledWalls::fraction() const {
  if (walls == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(doubled) / walls;
}

DoubledWalls doubled_walls(const OccupancyMap& map, const TrueMap& truth,
                           const DoubledWallOptions& options) {
  const NearCells known(cells_under(truth, map), 1,
                        [&](CellIndex cell) { return map[cell].known(); });
  const auto in_truth = [&](const Eigen::Vector2d& point) {
    const Eigen::Array2d cell = ((point - truth.origin) / truth.resolution).array().floor();
    return is_wall(truth, static_cast<int>(cell.x()), static_cast<int>(cell.y())) &&
           known[map.cell_of(point)];
  };
  const auto in_map = [&](const Eigen::Vector2d& point) {
    const Occupancy& cell = map[map.cell_of(point)];
    return cell.known() && cell.probability >= options.occupied;
  };
  DoubledWalls result;
  for (int y = 0; y < truth.height; ++y) {
    for (int x = 0; x < truth.width; ++x) {
      if (truth.at(x, y) != TrueCell::occupied) continue;
      const Eigen::Vector2d center =
          truth.origin + truth.resolution * Eigen::Vector2d(x + 0.5, y + 0.5);
      if (!known[map.cell_of(center)]) continue;
      const std::optional<Eigen::Vector2d> normal = normal_at(truth, x, y);
      if (!normal) continue;
      ++result.walls;
      const int there_are =
          count_walls(center, *normal, truth.resolution, options.reach, 1, in_truth);
      const int drawn =
          count_walls(center, *normal, map.resolution(), options.reach, options.gap, in_map);
      if (drawn > there_are) ++result.doubled;
    }
  }
  return result;
}

}  // namespace mapbed
