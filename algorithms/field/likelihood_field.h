#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "algorithms/field/field_points.h"
#include "algorithms/field/hit_mixture.h"
#include "algorithms/field/local_map.h"
#include "algorithms/grid/tiled_grid.h"
#include "core/config/option.h"
#include "core/geometry/pose2.h"

namespace mapbed {

struct LikelihoodFieldOptions {
  double resolution = 0.05;  // [m] side of a cell
  double sigma = 0.06;  // [m] of an end point about the mapped surface: noise, small pose errors
  double inlier_ratio = 0.85;  // in (0, 1): beams that the map explains; the rest may end anywhere
};

template <class Visitor>
void visit_fields(LikelihoodFieldOptions& o, Visitor&& visit) {
  visit("resolution", o.resolution, Unit::meter, between(0.005, 2.0), "side of a cell");
  visit("sigma", o.sigma, Unit::meter, between(0.001, 2.0),
        "sigma of end points about the mapped surface");
  visit("inlier_ratio", o.inlier_ratio, between(0.01, 0.999),
        "fraction of beams that the map explains; the rest may end anywhere");
}

// End-point model, section 2.2.4, smoothed as in section 2.3.2: the log-likelihood of a beam that
// ends at a point, by its distance to the nearest mapped surface (HitMixture).
//
// Each cell within 3 sigma of the surface knows the mapped point nearest to its centre and the line
// through it, and a point in the cell is measured against that line: far finer than the cells, and
// one look-up a point. Along its line a mapped point counts a tenth of its distance, so that walls
// do not hold scans where their points happen to lie, but end somewhere. Memory grows with the
// mapped surface. clear() keeps it for the next map.
class LikelihoodField {
 public:
  explicit LikelihoodField(const LikelihoodFieldOptions& options = {});

  void add(const SurfacePoint& point);  // [m] in the map frame
  void add(const std::vector<SurfacePoint>& points);
  void clear();

  // Brings the field of a local map up to date where these cells of it changed: the same as
  // clearing it and adding all means anew, in time of what changed. Cells are those of this field.
  void update(const SurfaceMeans& means, const std::vector<CellIndex>& changed);

  double log_at(const Eigen::Vector2d& point) const;  // [m] in the map frame
  float outlier_log() const { return outlier_log_; }  // log_at far from everything
  double resolution() const { return resolution_; }

  // Sum of log_at over the points, seen from a pose.
  double sum_log_at(const FieldPoints& points, const Pose2& map_from_robot) const;

  // How log_at changes about a point, by the line (or point) that it is measured against, without
  // the slight pull along a line, which depends on where the mapped points happen to lie.
  struct Shape {
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();  // [1/m]
    // [1/m^2] of -log_at, positive semidefinite
    Eigen::Matrix2d curvature = Eigen::Matrix2d::Zero();
  };
  Shape shape_at(const Eigen::Vector2d& point) const;

  // The mapped surface about a point: none farther off than 3 sigma.
  struct Surface {
    Eigen::Vector2d point = Eigen::Vector2d::Zero();  // [m] on it
    Eigen::Vector2d along = Eigen::Vector2d::Zero();  // of length 1; zero: no line is known
  };
  std::optional<Surface> surface_at(const Eigen::Vector2d& point) const;

  CellBox box() const;  // of the tiles in use
  std::vector<CellIndex> tile_corners() const;
  // For each cell of such a tile what a point in it can score at most: bytes in steps of
  // bound_step() above outlier_log(), row by row, `stride` bytes apart.
  void bound_tile(CellIndex corner, int stride, std::uint8_t* bounds) const;
  double bound_step() const { return -double{outlier_log_} / 255.0; }
  static constexpr int kTileBits = 5, kTileSide = 1 << kTileBits;

 private:
  static constexpr std::size_t kTileCells = std::size_t{kTileSide} * kTileSide;

  struct Cell {
    float x = kFar, y = kFar;  // from the cell's centre to the nearest mapped point [cells]
    float along_x = 0.0F;      // the line's direction, of length sqrt(1 - kAlong^2); zero: no line
    float along_y = 0.0F;
  };
  static constexpr float kFar = 1e6F;
  static constexpr double kAlong = 0.1;

  const Cell* cell_at(int x, int y) const;         // from the directory's corner; null: no tile
  float log_in_directory(float x, float y) const;  // [cells] from the directory's corner
  CellIndex middle_of(const Eigen::Vector2d& point) const;
  std::int32_t slot_for_writing(int tile_x, int tile_y);  // of a tile; an empty one if it is new
  Cell* tile_in(std::int32_t slot) { return &cells_[static_cast<std::size_t>(slot) * kTileCells]; }
  void release_tile(int tile_x, int tile_y);
  bool fill_tile(int tile_x, int tile_y, const SurfaceMeans& means, Cell* tile) const;
  void add_in_tile(const SurfacePoint& point, int tile_x, int tile_y, Cell* tile) const;
  void widen_directory(int tile_x, int tile_y);

  double resolution_;
  double sigma_;        // [m]
  HitMixture mixture_;  // of distances in cells
  float outlier_log_;
  int radius_;  // [cells] of the neighbourhood that one end point changes
  int min_x_ = 0, min_y_ = 0, width_ = 0, height_ = 0;  // of the directory [tiles]
  std::vector<std::int32_t> directory_;                 // tile number, -1 where there is none
  std::vector<Cell> cells_;                             // kTileCells for each tile, row by row
  std::int32_t tiles_ = 0;
  std::vector<std::uint8_t> bounds_;      // of bound_tile, by squared distance
  float bounds_per_square_ = 0.0F;        // d^2 -> index into them
  std::vector<std::int32_t> free_tiles_;  // below tiles_, in no place of the directory
};

}  // namespace mapbed
