#include "sim/actors/navigation_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "core/geometry/angle.h"
#include "core/input_error.h"
#include "worlds/geometry/footprint.h"

namespace mapbed {
namespace {

constexpr double kCell = 0.2;  // [m]
constexpr int kBlock = 2;      // cells along the side of a block that shares its near walls
constexpr double kBlockSize = kBlock * kCell;  // [m]
constexpr double kMargin = 1.0;                // [m] of grid around the outermost walls
constexpr double kMostCells = 2e7;
// A block's near walls: those within reach of any of its points.
constexpr double kBlockReach = NavigationMap::kReach + 0.7072 * kBlockSize;  // [m]

double distance_to(const Wall& wall, const Eigen::Vector2d& point) {
  const Eigen::Vector2d along = wall.to - wall.from;
  const double length2 = along.squaredNorm();
  const double fraction =
      length2 > 0.0 ? std::clamp((point - wall.from).dot(along) / length2, 0.0, 1.0) : 0.0;
  return std::max(0.0, (wall.from + fraction * along - point).norm() - wall.radius);
}

// Of a metre where there is so much room beside a disc: up to three times as much near walls.
double price_of(double room) {
  return 1.0 + 2.0 * std::clamp(1.0 - room / 0.4, 0.0, 1.0);
}

// What stands in the way between the two heights.
std::vector<Footprint> obstacles_of(const World& world, double low, double high) {
  std::vector<Footprint> obstacles = footprints(world, low, high);
  std::erase_if(obstacles, [&](const Footprint& f) {
    const EntityKind kind = world.entities[static_cast<std::size_t>(f.entity)].kind;
    return kind == EntityKind::floor || kind == EntityKind::door;
  });
  return obstacles;
}

std::vector<Wall> walls_of(const std::vector<Footprint>& obstacles) {
  std::vector<Wall> walls;
  for (const Footprint& f : obstacles) {
    if (f.outline.empty()) walls.push_back({f.center, f.center, f.radius});
    for (std::size_t i = 0; i < f.outline.size(); ++i) {
      walls.push_back({f.outline[i], f.outline[(i + 1) % f.outline.size()], 0.0});
    }
  }
  return walls;
}

double cells_in(const Eigen::Vector2d& size, double side) {
  return (size / side).array().ceil().max(1.0).prod();
}

// Walls are tried at all blocks of their boxes and kept in those near them, outlines are tried at
// all cells of theirs, corner by corner.
void check_cost(const std::string& world, const std::vector<Footprint>& obstacles,
                const std::vector<Wall>& walls, const NavigationCost& most) {
  NavigationCost cost{.looks = 0.0, .near_walls = 0.0};
  for (const Footprint& f : obstacles) {
    if (f.outline.empty()) continue;
    cost.looks += cells_in(bounds_of(f).sizes(), kCell) * static_cast<double>(f.outline.size());
  }
  for (const Wall& wall : walls) {
    const Eigen::Vector2d way = wall.to - wall.from;
    const double reach = wall.radius + kBlockReach;
    const Eigen::Vector2d size = way.cwiseAbs() + Eigen::Vector2d::Constant(2.0 * reach);
    cost.looks += cells_in(size, kBlockSize);
    cost.near_walls += (2.0 * way.norm() + kPi * reach) * reach / (kBlockSize * kBlockSize);
  }
  if (cost.looks <= most.looks && cost.near_walls <= most.near_walls) return;
  throw InputError("world '" + world +
                   "' has too many or too large things to walk or drive about in; make it smaller, "
                   "or its meshes simpler");
}

}  // namespace

Eigen::Vector2d nearest_point(const Wall& wall, const Eigen::Vector2d& point) {
  const Eigen::Vector2d along = wall.to - wall.from;
  const double length2 = along.squaredNorm();
  const double fraction =
      length2 > 0.0 ? std::clamp((point - wall.from).dot(along) / length2, 0.0, 1.0) : 0.0;
  const Eigen::Vector2d on_axis = wall.from + fraction * along;
  if (wall.radius <= 0.0) return on_axis;
  const Eigen::Vector2d out = point - on_axis;
  const double length = out.norm();
  return length > 0.0 ? Eigen::Vector2d(on_axis + wall.radius / length * out) : on_axis;
}

NavigationMap::NavigationMap(const World& world, double low, double high,
                             const NavigationCost& most) {
  const std::vector<Footprint> obstacles = obstacles_of(world, low, high);
  walls_ = walls_of(obstacles);
  check_cost(world.name, obstacles, walls_, most);
  lay_out_grid();
  sort_walls_into_blocks();
  measure_clearance();
  // Walls know their borders only; what is inside is not free either.
  for (const Footprint& f : obstacles) {
    if (f.outline.size() < 3) continue;
    const Eigen::AlignedBox2d box = bounds_of(f);
    for (double y = box.min().y() - kCell; y <= box.max().y() + kCell; y += kCell) {
      for (double x = box.min().x() - kCell; x <= box.max().x() + kCell; x += kCell) {
        const int cell = cell_of({x, y});
        if (cell >= 0 && mapbed::distance_to(f, center_of(cell)) <= 0.0) {
          clearance_[static_cast<std::size_t>(cell)] = 0.0F;
        }
      }
    }
  }
}

void NavigationMap::lay_out_grid() {
  Eigen::AlignedBox2d box(Eigen::Vector2d(-kMargin, -kMargin), Eigen::Vector2d(kMargin, kMargin));
  if (!walls_.empty()) box.setEmpty();
  for (const Wall& wall : walls_) {
    const Eigen::Vector2d r = Eigen::Vector2d::Constant(wall.radius + kMargin);
    box.extend(wall.from - r).extend(wall.from + r).extend(wall.to - r).extend(wall.to + r);
  }
  const Eigen::Vector2d blocks = box.sizes() / kBlockSize;
  if (!(blocks.prod() * kBlock * kBlock < kMostCells)) {
    throw InputError("the world is too large to walk or drive in: its floor plan measures " +
                     std::to_string(std::lround(box.sizes().x())) + " m x " +
                     std::to_string(std::lround(box.sizes().y())) +
                     " m; leave out what lies far from the paths");
  }
  corner_ = box.min();
  block_columns_ = static_cast<int>(blocks.x()) + 1;
  block_rows_ = static_cast<int>(blocks.y()) + 1;
  columns_ = block_columns_ * kBlock;
  rows_ = block_rows_ * kBlock;
}

void NavigationMap::sort_walls_into_blocks() {
  std::vector<std::vector<std::uint32_t>> near(static_cast<std::size_t>(block_columns_) *
                                               static_cast<std::size_t>(block_rows_));
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const Wall& wall = walls_[w];
    const Eigen::Vector2d r = Eigen::Vector2d::Constant(wall.radius + kBlockReach);
    const Eigen::Vector2d low = (wall.from.cwiseMin(wall.to) - r - corner_) / kBlockSize;
    const Eigen::Vector2d top = (wall.from.cwiseMax(wall.to) + r - corner_) / kBlockSize;
    const int last_row = std::min(block_rows_ - 1, static_cast<int>(top.y()));
    const int last_column = std::min(block_columns_ - 1, static_cast<int>(top.x()));
    for (int row = std::max(0, static_cast<int>(low.y())); row <= last_row; ++row) {
      for (int column = std::max(0, static_cast<int>(low.x())); column <= last_column; ++column) {
        const Eigen::Vector2d center =
            corner_ + kBlockSize * Eigen::Vector2d(column + 0.5, row + 0.5);
        if (distance_to(wall, center) > kBlockReach) continue;
        near[static_cast<std::size_t>(row * block_columns_ + column)].push_back(
            static_cast<std::uint32_t>(w));
      }
    }
  }
  first_near_.assign(1, 0);
  for (const auto& list : near) {
    for (const std::uint32_t w : list) near_walls_.push_back(walls_[w]);
    first_near_.push_back(static_cast<std::uint32_t>(near_walls_.size()));
  }
}

void NavigationMap::measure_clearance() {
  const int count = columns_ * rows_;
  clearance_.assign(static_cast<std::size_t>(count), static_cast<float>(kReach));
  for (int cell = 0; cell < count; ++cell) {
    const Eigen::Vector2d center = center_of(cell);
    float& value = clearance_[static_cast<std::size_t>(cell)];
    for (const Wall& wall : walls_near(center)) {
      value = std::min(value, static_cast<float>(distance_to(wall, center)));
    }
  }
}

int NavigationMap::cell_of(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d p = (point - corner_) / kCell;
  if (!(p.x() >= 0.0 && p.y() >= 0.0 && p.x() < columns_ && p.y() < rows_)) return -1;
  return static_cast<int>(p.y()) * columns_ + static_cast<int>(p.x());
}

Eigen::Vector2d NavigationMap::center_of(int cell) const {
  return corner_ + kCell * Eigen::Vector2d(cell % columns_ + 0.5, cell / columns_ + 0.5);
}

std::span<const Wall> NavigationMap::walls_near(const Eigen::Vector2d& point) const {
  const int cell = cell_of(point);
  if (cell < 0) return {};
  const std::size_t block = static_cast<std::size_t>(cell / columns_ / kBlock * block_columns_ +
                                                     cell % columns_ / kBlock);
  return {near_walls_.data() + first_near_[block], first_near_[block + 1] - first_near_[block]};
}

double NavigationMap::clearance(const Eigen::Vector2d& point) const {
  const int cell = cell_of(point);
  if (cell < 0) return kReach;
  const double coarse = clearance_[static_cast<std::size_t>(cell)];
  if (coarse <= 0.0) return 0.0;
  double exact = kReach;
  for (const Wall& wall : walls_near(point)) exact = std::min(exact, distance_to(wall, point));
  return exact;
}

bool NavigationMap::is_straight_way(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                    double radius) const {
  const double length = (to - from).norm();
  for (double s = 0.0;;) {
    const double room = clearance(from + (length > 0.0 ? s / length : 0.0) * (to - from)) - radius;
    if (room < 0.0) return false;
    if (s >= length) return true;
    s = std::min(length, s + std::max(room, 0.02));  // nothing is nearer than `room`
  }
}

// A* on the grid's cells.
std::vector<int> NavigationMap::cells_to(int start, int goal, double radius) const {
  struct Entry {
    float total;
    int cell;
    bool operator<(const Entry& other) const {
      return total != other.total ? total > other.total : cell > other.cell;
    }
  };
  const std::size_t count = clearance_.size();
  std::vector<float> cost(count, std::numeric_limits<float>::infinity());
  std::vector<int> from(count, -1);
  std::priority_queue<Entry> open;
  const auto to_go = [&](int cell) {
    return static_cast<float>((center_of(cell) - center_of(goal)).norm());
  };
  cost[static_cast<std::size_t>(start)] = 0.0F;
  open.push({to_go(start), start});
  while (!open.empty()) {
    const auto [total, cell] = open.top();
    open.pop();
    if (cell == goal) break;
    const float so_far = cost[static_cast<std::size_t>(cell)];
    if (total > so_far + to_go(cell) + 1e-3F) continue;  // found a cheaper way meanwhile
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int column = cell % columns_ + dx;
        const int row = cell / columns_ + dy;
        if (column < 0 || row < 0 || column >= columns_ || row >= rows_) continue;
        const int next = row * columns_ + column;
        const double room = clearance_[static_cast<std::size_t>(next)] - radius;
        if (room < 0.0 && next != goal) continue;
        const double way = kCell * std::hypot(dx, dy) * price_of(room);
        const float new_cost = so_far + static_cast<float>(way);
        if (new_cost >= cost[static_cast<std::size_t>(next)]) continue;
        cost[static_cast<std::size_t>(next)] = new_cost;
        from[static_cast<std::size_t>(next)] = cell;
        open.push({new_cost + to_go(next), next});
      }
    }
  }
  if (from[static_cast<std::size_t>(goal)] < 0) return {};
  std::vector<int> cells;
  for (int cell = goal; cell != -1; cell = from[static_cast<std::size_t>(cell)]) {
    cells.push_back(cell);
  }
  std::reverse(cells.begin(), cells.end());
  return cells;
}

std::optional<std::vector<Eigen::Vector2d>> NavigationMap::way(const Eigen::Vector2d& from,
                                                               const Eigen::Vector2d& to,
                                                               double radius) const {
  if (is_straight_way(from, to, radius)) return std::vector<Eigen::Vector2d>{from, to};
  const int start = cell_of(from);
  const int goal = cell_of(to);
  if (start < 0 || goal < 0) return std::nullopt;
  if (start == goal) return std::vector<Eigen::Vector2d>{from, to};
  const std::vector<int> cells = cells_to(start, goal, radius);
  if (cells.empty()) return std::nullopt;

  // Straight where it can be: from each corner to the last cell in sight.
  std::vector<Eigen::Vector2d> corners{from};
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const bool is_last = i + 1 == cells.size();
    const Eigen::Vector2d next = is_last ? to : center_of(cells[i + 1]);
    if (!is_last && is_straight_way(corners.back(), next, radius)) continue;
    corners.push_back(is_last ? to : center_of(cells[i]));
  }
  return corners;
}

}  // namespace mapbed
