#pragma once

#include <string>

#include "core/geometry/pose2.h"
#include "worlds/world.h"

namespace mapbed {

// Pieces by their usual sizes [m], with the detail that a laser between 0.1 m and 1 m above the
// floor meets: legs, feet, bases. `pose` is the middle on the floor; what stands at a wall has its
// back towards -x. The world gives the material numbers and is not changed.

Entity desk(const World& world, const Pose2& pose, double width = 1.6, double depth = 0.8);
Entity table(const World& world, const Pose2& pose, double width = 2.0, double depth = 1.0);
Entity office_chair(const World& world, const Pose2& pose);  // five feet round one post
Entity chair(const World& world, const Pose2& pose);         // four legs
Entity cabinet(const World& world, const Pose2& pose, double width = 0.9, double depth = 0.45,
               double height = 1.9);
Entity bin(const World& world, const Pose2& pose);
Entity plant(const World& world, const Pose2& pose);
Entity bench(const World& world, const Pose2& pose, double length = 1.8);
Entity column(const World& world, const Pose2& pose, double radius, const std::string& material);
Entity showcase(const World& world, const Pose2& pose, double width, double depth);
Entity pedestal(const World& world, const Pose2& pose, double width);  // with a figure on it
Entity rope_post(const World& world, const Pose2& pose);  // as thin as a leg and thinner

}  // namespace mapbed
