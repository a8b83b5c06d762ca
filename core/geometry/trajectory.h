#pragma once

#include <optional>
#include <vector>

#include "core/geometry/pose2.h"
#include "core/geometry/stamped.h"

namespace mapbed {

// A path: poses in order of time; equal stamps are allowed (the later one in the list is newer).
using Trajectory = std::vector<Stamped<Pose2>>;

// The pose at a time, linearly between its neighbours (interpolate()); none before the first and
// after the last pose, and for an empty trajectory.
std::optional<Pose2> pose_at(const Trajectory& trajectory, double time);

double path_length(const Trajectory& trajectory);  // [m]

}  // namespace mapbed
