#pragma once

#include <iosfwd>

#include <gmock/gmock.h>

#include "core/geometry/pose2.h"

namespace mapbed {

struct Tolerance {
  double position;  // [m]
  double heading;   // [rad]
};

void PrintTo(const Pose2& pose, std::ostream* out);

// The one matcher for poses; a failure prints the error in metres and radians.
::testing::Matcher<const Pose2&> IsNear(const Pose2& expected, const Tolerance& tolerance);

}  // namespace mapbed
