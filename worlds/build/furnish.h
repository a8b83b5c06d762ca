#pragma once

#include <Eigen/Geometry>

#include "core/random.h"
#include "worlds/build/furniture_placer.h"

namespace mapbed {

// Desks with their chairs, cabinets, bins and plants along the walls of a rectangular room (middle
// lines of its walls), a table with chairs in a meeting room; about one piece for every 4 m^2 at
// `fullness` 1. What finds no place is left out.
void furnish_office_room(FurniturePlacer& placer, const World& world,
                         const Eigen::AlignedBox2d& room, bool meeting_room, double fullness,
                         Rng& rng);

// A pose with its back (-x) at a wall of the room, `from_wall` [m] from the wall's middle line.
Pose2 pose_at_wall(const Eigen::AlignedBox2d& room, double from_wall, Rng& rng);

}  // namespace mapbed
