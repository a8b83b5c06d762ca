#include "core/sensor/mount.h"

#include <cmath>

#include "core/geometry/pose3.h"

namespace mapbed {

Pose3 Mount::pose() const {
  return {{planar.x, planar.y, z}, rotation_of(planar.theta, pitch, roll)};
}

bool Mount::is_level() const {
  constexpr double kLevel = 0.0017453292519943296;  // [rad] 0.1 degrees
  return std::hypot(pitch, roll) <= kLevel;
}

}  // namespace mapbed
