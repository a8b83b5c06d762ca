#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "algorithms/field/field_points.h"
#include "algorithms/field/hit_mixture.h"
#include "algorithms/field/processor.h"
#include "algorithms/grid/occupancy_map.h"
#include "core/geometry/pose2.h"

namespace mapbed {

// How likely a beam's end is in each cell of a map, by its distance to the nearest occupied one
// (HitMixture): section 2.2.4's end points for a map that is given and stays as it is. One float a
// cell and one look-up a beam, for as many particles as a global search needs. An end where nothing
// is known counts as one far from everything, so that no place is likely for what the map does not
// show.
class EndPointTable {
 public:
  EndPointTable(const OccupancyMap& map, double sigma, double inlier_ratio);  // [m]

  double resolution() const { return frame_.resolution; }
  double outlier_log() const { return mixture_.outlier_log(); }
  float log_at(const Eigen::Vector2d& point) const;  // [m] in the map frame

  // sums[i]: of the points' logs times their weights, seen from map_from_robot[i]. Points in cells
  // of this table, in the robot frame. The same bytes for any processor and number of threads.
  void sums(std::span<const Pose2> map_from_robot, const FieldPoints& points, std::span<float> sums,
            Processor processor = this_processor()) const;

  // The same for one pose, point by point: what sums() is tested against.
  float sum(const Pose2& map_from_robot, const FieldPoints& points) const;

  // Of the points that end where the map tells anything: their weight, and the sum of their logs.
  struct Told {
    double weight = 0.0;
    double log = 0.0;
  };
  Told told(const Pose2& map_from_robot, const FieldPoints& points) const;

 private:
  std::size_t index_of(float x, float y) const;

  GridFrame frame_;
  CellIndex corner_;  // of the table, a cell outside the map
  int width_ = 0, height_ = 0;
  HitMixture mixture_;
  std::vector<float> logs_;    // row by row
  std::vector<bool> is_told_;  // the cell is known, or a wall is near
};

}  // namespace mapbed
