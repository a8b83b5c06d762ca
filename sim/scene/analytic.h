#pragma once

#include <optional>

#include <Eigen/Core>

#include "sim/scene/ray.h"
#include "worlds/geometry/shape.h"

namespace mapbed {

// Where a ray meets the border of a solid.
struct Crossing {
  double range = 0.0;      // [m]
  Eigen::Vector3d normal;  // unit, out of the solid
};

// The first crossing between the ray's two ranges, from outside or from inside; ray and result in
// the shape's own frame. Double precision throughout.
std::optional<Crossing> first_crossing(const Box& box, const Ray& ray);
std::optional<Crossing> first_crossing(const Cylinder& cylinder, const Ray& ray);

}  // namespace mapbed
