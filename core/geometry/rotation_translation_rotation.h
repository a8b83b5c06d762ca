#pragma once

#include "core/geometry/pose2.h"

namespace mapbed {

// A motion in the plane as the models of odometry see it: a rotation, a straight translation and a
// rotation (Figure 5.2). Driving backwards is a negative translation, not a rotation by pi.
struct RotationTranslationRotation {
  double first_rotation = 0.0;   // [rad] in [-pi/2, pi/2]
  double translation = 0.0;      // [m] negative: backwards
  double second_rotation = 0.0;  // [rad]
};

// A motion shorter than `least_translation` [m] has no direction: it is its forward part and one
// rotation, the second.
RotationTranslationRotation decomposed(const Pose2& motion, double least_translation);

Pose2 composed(const RotationTranslationRotation& parts);

}  // namespace mapbed
