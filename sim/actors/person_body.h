#pragma once

#include <string>

#include "sim/actors/crowd.h"
#include "worlds/world.h"

namespace mapbed {

// Parts of a person's entity, by index.
enum PersonPart : int { kLeftLeg = 0, kRightLeg = 1, kTrunk = 2 };

// What a ray can hit of a person: two upright cylinders of 7 cm radius up to the hip, the trunk
// above. `material` is an index into the world's materials.
Entity person_entity(const std::string& name, const PersonView& person, int material);

// Where a leg stands in the frame of the entity (the body's, on the floor).
Pose3 entity_from_leg(const Eigen::Vector2d& leg);

}  // namespace mapbed
