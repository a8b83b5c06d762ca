#pragma once

#include <string>
#include <vector>

#include "algorithms/grid/occupancy_map.h"
#include "algorithms/tag_belief.h"
#include "core/image/image.h"

namespace mapbed {

// A tag's belief after so many detections, Figure 7.7.
struct BeliefMoment {
  int detections = 0;
  TagBelief belief;
  Eigen::Vector2d robot = Eigen::Vector2d::Zero();  // [m] where it was then
};

// Discs as wide as each position's weight over the largest; the true place a cross.
RgbImage belief_figure(const std::vector<BeliefMoment>& moments, const Eigen::Vector2d& truth);

// Where a tag truly is and where it was mapped.
struct MappedTag {
  Eigen::Vector2d truth = Eigen::Vector2d::Zero();  // [m]
  Eigen::Vector2d mapped = Eigen::Vector2d::Zero();
};

// Figure 7.11: all tags on the map of the place.
RgbImage tag_map_figure(const OccupancyMap& map, const std::vector<MappedTag>& tags);

// Figure 7.8: from where one tag was heard by which antenna.
RgbImage heard_from_figure(const OccupancyMap& map, const std::vector<Eigen::Vector2d>& left,
                           const std::vector<Eigen::Vector2d>& right, const Eigen::Vector2d& tag);

}  // namespace mapbed
