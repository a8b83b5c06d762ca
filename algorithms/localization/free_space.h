#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "algorithms/grid/occupancy_map.h"
#include "core/geometry/pose2.h"
#include "core/random.h"

namespace mapbed {

// Where a robot may stand by a map: the cells that are known to be free. What is unknown is not.
class FreeSpace {
 public:
  explicit FreeSpace(std::shared_ptr<const OccupancyMap> map);

  // Only what lies within `distance` [m] of one of the poses.
  FreeSpace near(std::span<const Pose2> poses, double distance) const;

  bool empty() const { return cells_.empty(); }
  double area() const;  // [m^2]
  bool contains(const Eigen::Vector2d& point) const;
  Pose2 sample(Rng& rng) const;  // uniform in position and heading; not where it is empty
  const OccupancyMap& map() const { return *map_; }

 private:
  std::shared_ptr<const OccupancyMap> map_;
  std::vector<CellIndex> cells_;
};

// Of a cell: known, and rather occupied, or rather free.
inline bool is_occupied(const Occupancy& cell) {
  return cell.probability > 0.5F;
}
inline bool is_free(const Occupancy& cell) {
  return cell.known() && cell.probability < 0.5F;
}

// What of a map tells a start: "in a wall", "outside the map", "in unknown space"; none: it is
// free.
std::optional<std::string> trouble_at(const OccupancyMap& map, const Eigen::Vector2d& point);

}  // namespace mapbed
