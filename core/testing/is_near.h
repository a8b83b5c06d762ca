#pragma once

#include <cmath>
#include <ostream>

#include <gmock/gmock.h>

#include "core/geometry/angle.h"
#include "core/geometry/pose2.h"

namespace mapbed {

struct Tolerance {
  double position;  // [m]
  double heading;   // [rad]
};

inline void PrintTo(const Pose2& pose, std::ostream* out) {
  *out << "(" << pose.x << " m, " << pose.y << " m, " << degrees(pose.theta) << " deg)";
}

// The one matcher for poses; a failure prints the error in metres and radians.
MATCHER_P2(IsNear, expected, tolerance, "is near " + ::testing::PrintToString(expected)) {
  const double off = distance(arg, expected);
  const double turned = std::abs(angle_difference(arg.theta, expected.theta));
  *result_listener << "which is off by " << off << " m and " << turned << " rad";
  return off <= tolerance.position && turned <= tolerance.heading;
}

}  // namespace mapbed
