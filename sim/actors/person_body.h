#pragma once

#include <array>
#include <string>

#include "sim/actors/moving_pose.h"
#include "worlds/geometry/shape.h"

namespace mapbed {

// Parts of a person's entity, by index.
enum PersonPart : int { kLeftLeg = 0, kRightLeg = 1, kTrunk = 2 };

// Somebody as he stands: world_from_body with x where he looks, and the axes of the left and the
// right leg in the body frame. [m]
struct PersonPosture {
  Pose2 world_from_body;
  std::array<Eigen::Vector2d, 2> legs;
};

// What a ray can hit of a person: two upright cylinders of 7 cm radius up to the hip, the trunk
// above. `material` is an index into the world's materials.
Entity person_entity(const std::string& name, const PersonPosture& posture, int material);

// world_from_part of the parts, by index.
std::array<Pose3, 3> part_poses(const PersonPosture& posture);

}  // namespace mapbed
