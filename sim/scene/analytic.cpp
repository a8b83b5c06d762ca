#include "sim/scene/analytic.h"

#include <cmath>
#include <limits>
#include <utility>

namespace mapbed {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The part of a ray's line that runs inside a convex solid.
struct Inside {
  Crossing in{-kInfinity, Eigen::Vector3d::Zero()};
  Crossing out{kInfinity, Eigen::Vector3d::Zero()};
  bool empty = false;

  // Cuts the line down to the layer |p[axis]| <= half.
  void cut_to_layer(const Ray& ray, int axis, double half) {
    const double start = ray.origin[axis];
    const double slope = ray.direction[axis];
    if (slope == 0.0) {
      if (std::abs(start) > half) empty = true;
      return;
    }
    const double side = slope > 0.0 ? -1.0 : 1.0;  // of the face where the line comes in
    const Eigen::Vector3d normal = side * Eigen::Vector3d::Unit(axis);
    cut({(side * half - start) / slope, normal}, {(-side * half - start) / slope, -normal});
  }

  void cut(const Crossing& from, const Crossing& to) {
    if (from.range > in.range) in = from;
    if (to.range < out.range) out = to;
    if (in.range > out.range) empty = true;
  }

  std::optional<Crossing> first_within(const Ray& ray) const {
    if (empty) return std::nullopt;
    for (const Crossing& crossing : {in, out}) {
      if (crossing.range >= ray.min_range) {
        return crossing.range <= ray.max_range ? std::optional(crossing) : std::nullopt;
      }
    }
    return std::nullopt;
  }
};

}  // namespace

std::optional<Crossing> first_crossing(const Box& box, const Ray& ray) {
  Inside inside;
  for (int axis = 0; axis < 3; ++axis) inside.cut_to_layer(ray, axis, box.size[axis] / 2);
  return inside.first_within(ray);
}

std::optional<Crossing> first_crossing(const Cylinder& cylinder, const Ray& ray) {
  // |o + t d|^2 = r^2 in the plane: a t^2 + 2 b t + c = 0
  const Eigen::Vector2d o = ray.origin.head<2>();
  const Eigen::Vector2d d = ray.direction.head<2>();
  const double a = d.squaredNorm();
  const double b = o.dot(d);
  const double c = o.squaredNorm() - cylinder.radius * cylinder.radius;
  if (a == 0.0) {
    if (c > 0.0) return std::nullopt;  // runs beside the cylinder, along its axis
    Inside inside;
    inside.cut_to_layer(ray, 2, cylinder.height / 2);
    return inside.first_within(ray);
  }
  // Most rays that come this far pass by.
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0 || (c > 0.0 && b > 0.0 && ray.min_range >= 0.0)) return std::nullopt;
  const double root = std::sqrt(discriminant);
  const auto at = [&](double range) {
    const Eigen::Vector2d outwards = (o + range * d) / cylinder.radius;
    return Crossing{range, {outwards.x(), outwards.y(), 0.0}};
  };
  Inside inside;
  inside.cut_to_layer(ray, 2, cylinder.height / 2);
  inside.cut(at((-b - root) / a), at((-b + root) / a));
  return inside.first_within(ray);
}

}  // namespace mapbed
