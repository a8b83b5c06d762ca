#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "algorithms/grid/tiled_grid.h"
#include "algorithms/scan/surface_points.h"
#include "core/config/option.h"
#include "core/geometry/pose2.h"

namespace mapbed {

struct LocalMapOptions {
  int max_scans = 100;        // alpha of Algorithm 1
  int max_history = 100'000;  // beta: how many scans back to look at most
  double min_distance = 0.5;  // [m] gamma, between integrated scans
  double min_turn = 0.5;  // [rad] a scan turned by more is integrated too: it shows other things
  double max_gap = 0.2;   // [m] neighbouring end points that are nearer belong to one surface
};

template <class Visitor>
void visit_fields(LocalMapOptions& o, Visitor&& visit) {
  visit("max_scans", o.max_scans, between(1, 100'000),
        "scans in the local map at most (alpha of Algorithm 1)");
  visit("max_history", o.max_history, between(1, 10'000'000),
        "scans to look back at most (beta of Algorithm 1)");
  visit("min_distance", o.min_distance, Unit::meter, kNotNegative,
        "between integrated scans (gamma of Algorithm 1)");
  visit("min_turn", o.min_turn, Unit::radian, kNotNegative,
        "between integrated scans that are closer than that");
  visit("max_gap", o.max_gap, Unit::meter, kNotNegative,
        "neighbouring end points that are nearer belong to one surface");
}

// Algorithm 1, section 2.2.4: which past scans make the local map. Walks back from the newest pose,
// which is always taken, and takes a scan that is at least min_distance (or min_turn) away from the
// one taken before it. Newest first.
std::vector<std::size_t> select_local_scans(const std::vector<Pose2>& poses,
                                            const LocalMapOptions& options);

// Whether a scan at `pose` is far enough from the one integrated before it.
bool is_far_enough(const Pose2& integrated, const Pose2& pose, const LocalMapOptions& options);

// The surfaces of a local map, one point for each cell that was hit: the mean of the points that
// fell in. Averaging takes out the noise of single scans and makes the map independent of how often
// a surface was seen, (2.17). Sums are of whole numbers (steps of 60 nm), so that points can be
// taken out again and the means do not depend on the order.
class SurfaceMeans {
 public:
  explicit SurfaceMeans(double resolution) : slots_(resolution) {}

  void add(const std::vector<SurfacePoint>& points_in_map);
  void remove(const std::vector<SurfacePoint>& points_in_map);  // that were added before
  void clear();  // in time of the cells hit, keeping the memory

  std::optional<SurfacePoint> mean_in(CellIndex cell) const;
  // visit(mean) for the cells of a box that were hit, row by row.
  template <class Visitor>
  void for_each_in(const CellBox& box, Visitor&& visit) const {
    slots_.for_each_in(box, [&](CellIndex, std::uint32_t slot) {
      if (slot != kNotHit) visit(mean_of(cells_[slot]));
    });
  }
  std::vector<SurfacePoint> means() const;  // in the order in which the cells were first hit

  // The cells whose means were changed since this was asked last; one may stand there twice.
  std::vector<CellIndex> take_changed();

 private:
  struct Cell {
    std::int64_t x = 0, y = 0;                  // sum of positions [steps]
    std::int64_t doubled_x = 0, doubled_y = 0;  // sum of directions [steps]
    std::int32_t count = 0;
    bool changed = false;  // in changed_cells_
  };
  static constexpr std::uint32_t kNotHit = 0;
  void count(const SurfacePoint& point, int sign);
  Cell& cell_for_writing(CellIndex index);
  void release(CellIndex index);
  static SurfacePoint mean_of(const Cell& cell);

  // Where a cell lies in cells_: a local map that moves on leaves no more behind than this.
  TiledGrid<std::uint32_t> slots_;
  std::vector<Cell> cells_{1};  // the first stands for kNotHit
  std::vector<std::uint32_t> free_slots_;
  std::vector<CellIndex> hit_cells_;
  std::vector<CellIndex> changed_cells_;
};

}  // namespace mapbed
