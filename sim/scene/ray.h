#pragma once

#include <limits>

#include <Eigen/Core>

namespace mapbed {

struct Ray {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;  // of unit length
  double min_range = 0.0;     // [m] hits nearer than this do not count
  double max_range = std::numeric_limits<double>::infinity();
  bool through_glass = false;  // as if everything with a transmittance > 0 were not there
};

// The nearest surface on a ray.
struct Hit {
  double range = std::numeric_limits<double>::infinity();  // [m]; infinite: nothing was hit
  int entity = -1;                                         // -1: nothing was hit
  int part = -1;                                           // index into the entity's parts
  int material = -1;                                       // index into the world's materials
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();        // unit, out of the solid, world frame

  bool is_hit() const { return entity >= 0; }
};

}  // namespace mapbed
