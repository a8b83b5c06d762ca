#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "algorithms/grid/occupancy_map.h"

namespace mapbed {

// Which tags can be seen from where on a map: looked up once, by squares of the free ground.
class TagVisibility {
 public:
  static constexpr double kSquare = 0.5;  // [m]

  // Of tags [m] up to a distance [m].
  TagVisibility(const OccupancyMap& map, std::span<const Eigen::Vector2d> tags, double distance);

  // The tags' numbers; none off the free ground.
  std::span<const std::uint32_t> from(const Eigen::Vector2d& place) const;

 private:
  GridFrame squares_{.resolution = kSquare, .origin = Eigen::Vector2d::Zero()};
  TiledGrid<std::int32_t> lists_;                      // number of the square's list, from 1
  std::vector<std::vector<std::uint32_t>> tags_seen_;  // by list
};

// Whether nothing occupied is between two places, but for what is within LineOfSight::kThickness
// of the second.
bool is_in_sight(const OccupancyMap& map, const Eigen::Vector2d& from, const Eigen::Vector2d& to);

}  // namespace mapbed
