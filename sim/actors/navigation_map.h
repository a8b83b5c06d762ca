#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "worlds/world.h"

namespace mapbed {

// A straight border of something solid; a post where both ends are the same.
struct Wall {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  double radius = 0.0;  // [m] of a round post; 0 for flat things
};

// The point of the wall's border nearest to `point`, which is outside.
Eigen::Vector2d nearest_point(const Wall& wall, const Eigen::Vector2d& point);

// What laying out a map takes: times that a cell is compared with the side of something, seconds
// for 5e8; walls in the lists of blocks, 44 bytes each.
struct NavigationCost {
  double looks = 5e8;
  double near_walls = 1.5e7;
};

// Where one can walk or drive: what stands on the floor, door leaves excepted, seen from above.
// A grid finds ways; distances are exact.
class NavigationMap {
 public:
  // Of everything that reaches into the band between the two heights [m]. Throws InputError where
  // the world is too large for a grid, or takes more than `most`.
  NavigationMap(const World& world, double low, double high, const NavigationCost& most = {});

  // Every wall within kReach of the point.
  std::span<const Wall> walls_near(const Eigen::Vector2d& point) const;
  // To the nearest wall, [m], kReach where there is none that near; 0 inside solids.
  double clearance(const Eigen::Vector2d& point) const;
  // That a disc can go straight from one point to the other.
  bool is_straight_way(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double radius) const;
  // A short way for a disc, `from` and `to` included, that keeps off walls where there is room;
  // none where there is no way.
  std::optional<std::vector<Eigen::Vector2d>> way(const Eigen::Vector2d& from,
                                                  const Eigen::Vector2d& to, double radius) const;

  static constexpr double kReach = 1.0;  // [m]

 private:
  void lay_out_grid();
  void sort_walls_into_blocks();
  void measure_clearance();
  int cell_of(const Eigen::Vector2d& point) const;  // -1 outside
  Eigen::Vector2d center_of(int cell) const;
  std::vector<int> cells_to(int start, int goal, double radius) const;

  std::vector<Wall> walls_;
  Eigen::Vector2d corner_ = Eigen::Vector2d::Zero();  // [m] lowest x and y of the grid
  int columns_ = 0;
  int rows_ = 0;
  std::vector<float> clearance_;           // [m] at cell centres, row by row
  std::vector<Wall> near_walls_;           // of block after block
  std::vector<std::uint32_t> first_near_;  // of each block; one more at the end
  int block_columns_ = 0;
  int block_rows_ = 0;
};

}  // namespace mapbed
