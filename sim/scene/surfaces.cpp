#include "sim/scene/surfaces.h"

#include <cmath>

#include "core/check.h"

namespace mapbed {

bool is_analytic(const Geometry& geometry) {
  return std::holds_alternative<Box>(geometry) || std::holds_alternative<Cylinder>(geometry);
}

Solid::Solid(const PlacedPart& placed) : placed_(placed) {
  CHECK(is_analytic(placed.geometry));
  place(placed.world_from_part, placed.visible);
}

void Solid::place(const Pose3& world_from_part, bool visible) {
  placed_.world_from_part = world_from_part;
  placed_.visible = visible;
  part_from_world_ = world_from_part.rotation.toRotationMatrix().transpose();
  is_round_ = std::holds_alternative<Cylinder>(placed_.geometry) && part_from_world_(2, 2) == 1.0;
}

Eigen::Vector3d Solid::half_extent() const {
  const Eigen::Matrix3d world_from_part = part_from_world_.transpose();
  if (const auto* box = std::get_if<Box>(&placed_.geometry)) {
    return world_from_part.cwiseAbs() * box->size / 2;
  }
  // A disc about the axis a reaches r sqrt(1 - a_i^2) along axis i.
  const auto& cylinder = std::get<Cylinder>(placed_.geometry);
  const Eigen::Array3d axis = world_from_part.col(2);
  const Eigen::Array3d disc = (1.0 - axis.square()).max(0.0).sqrt();
  return axis.abs() * cylinder.height / 2 + disc * cylinder.radius;
}

std::optional<Crossing> Solid::first_crossing(const Ray& ray) const {
  Ray in_part = ray;
  if (is_round_) {
    in_part.origin -= center();
    return mapbed::first_crossing(std::get<Cylinder>(placed_.geometry), in_part);
  }
  in_part.origin = part_from_world_ * (ray.origin - center());
  in_part.direction = part_from_world_ * ray.direction;
  const auto* cylinder = std::get_if<Cylinder>(&placed_.geometry);
  std::optional<Crossing> crossing =
      cylinder ? mapbed::first_crossing(*cylinder, in_part)
               : mapbed::first_crossing(std::get<Box>(placed_.geometry), in_part);
  if (crossing) crossing->normal = part_from_world_.transpose() * crossing->normal;
  return crossing;
}

void Triangles::add(const TriangleMesh& mesh, const Pose3& frame_from_mesh, int owner) {
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d p = frame_from_mesh * mesh.vertices[a];
    const Eigen::Vector3d q = frame_from_mesh * mesh.vertices[b];
    const Eigen::Vector3d r = frame_from_mesh * mesh.vertices[c];
    const Eigen::Vector3d across = (q - p).cross(r - p);
    if (across.squaredNorm() == 0.0) continue;  // covers nothing
    for (const Eigen::Vector3d& corner : {p, q, r}) {
      for (int axis = 0; axis < 3; ++axis) corners.push_back(static_cast<float>(corner[axis]));
    }
    const Eigen::Vector3d normal = across.normalized();
    planes.push_back({normal, normal.dot((p + q + r) / 3.0)});
    owners.push_back(owner);
  }
}

Crossing crossing_with(const Plane& plane, const Ray& ray, double about) {
  const double towards = plane.normal.dot(ray.direction);
  const double range = (plane.offset - plane.normal.dot(ray.origin)) / towards;
  // Single precision is good to 1e-6 of coordinates below 1 km; further off, the ray runs within
  // the plane.
  const bool agrees = std::abs(range - about) <= 1e-3 * (1.0 + about);
  return {agrees ? range : about, plane.normal};
}

}  // namespace mapbed
