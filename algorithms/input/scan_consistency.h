#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/geometry/pose2.h"

namespace mapbed {

// How far the points of one scan lie from those of another [m], in the mean, both in their robot
// frames: distances count up to `reach` [m] alone, as what only one of the scans saw says nothing.
// Where the scans are near each other and `a_from_b` is how the robot moved, it is small, unless
// the beams do not point where they are taken to.
double mismatch(const std::vector<Eigen::Vector2d>& in_a, const std::vector<Eigen::Vector2d>& in_b,
                const Pose2& a_from_b, double reach = 0.3);

}  // namespace mapbed
