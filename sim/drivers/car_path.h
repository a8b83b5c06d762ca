#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/geometry/pose2.h"
#include "sim/actors/navigation_map.h"
#include "sim/actors/obstacle.h"

namespace mapbed {

// A body that cannot turn on the spot, seen from the point that rolls without slip: the middle of a
// car's rear axle.
struct CarBody {
  double ahead = 0.0;           // [m] of that point is the middle of the body
  double length = 0.0;          // [m]
  double width = 0.0;           // [m]
  double turning_radius = 0.0;  // [m] the least, of that point
};

struct CarPathPoint {
  Pose2 pose;              // world_from_axle
  bool backwards = false;  // how it is reached
};

// Whether the body keeps `margin` [m] off all people.
bool is_free_of(std::span<const Obstacle> people, double margin, const CarBody& body,
                const Pose2& world_from_axle);

struct CarPathOptions {
  double margin = 0.1;          // [m] kept from walls; less where the start has less
  double people_margin = 0.25;  // [m] kept from what is in `people`
  double tolerance = 0.2;       // [m] the body's middle comes as near to the goal
  int most_places = 60'000;     // that are tried; then there is no path
};

// A path of arcs and straight lines, forwards and backwards, that the whole body can follow without
// touching a wall or one of the `people`: a best-first search over places and headings along
// the shortest way of a disc (hybrid A*, Dolgov et al. 2010, with that way as its heuristic). Poses
// are a tenth of a metre apart or less, the first one is `start`. None where none was found.
std::optional<std::vector<CarPathPoint>> plan_car_path(const NavigationMap& map,
                                                       const CarBody& body, const Pose2& start,
                                                       const Eigen::Vector2d& goal,
                                                       std::span<const Obstacle> people,
                                                       const CarPathOptions& options);

}  // namespace mapbed
