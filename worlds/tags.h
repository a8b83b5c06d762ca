#pragma once

#include <string>

#include "worlds/world.h"

namespace mapbed {

// On a wall: a centimetre before `point`, which is on its surface [m], and looking along `facing`
// [rad]; the dipole lies level.
RfidTag tag_on_wall(const std::string& id, const Eigen::Vector3d& point, double facing,
                    int material);

// The material of what is right behind a tag, within 10 cm; kNothing where it hangs free.
int material_behind(const World& world, const Pose3& world_from_tag);

// Throws InputError where the tag's id is not one word or another tag's, or it lies inside
// something.
void check_tag(const World& world, const RfidTag& tag);

}  // namespace mapbed
