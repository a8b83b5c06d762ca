#include "core/geometry/rotation_translation_rotation.h"

#include <cmath>

#include "core/geometry/angle.h"

namespace mapbed {

RotationTranslationRotation decomposed(const Pose2& motion, double least_translation) {
  const double length = std::hypot(motion.x, motion.y);
  if (length < least_translation) return {0.0, motion.x, motion.theta};
  double first = std::atan2(motion.y, motion.x);
  const bool backwards = std::abs(first) > kPi / 2;
  if (backwards) first = normalized_angle(first + kPi);
  return {first, backwards ? -length : length, angle_difference(first, motion.theta)};
}

Pose2 composed(const RotationTranslationRotation& parts) {
  return {parts.translation * std::cos(parts.first_rotation),
          parts.translation * std::sin(parts.first_rotation),
          normalized_angle(parts.first_rotation + parts.second_rotation)};
}

}  // namespace mapbed
