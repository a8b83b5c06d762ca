#include "sim/sensors/rfid/mirror_faces.h"

#include <algorithm>

namespace mapbed {
namespace {

using Corners = std::vector<Eigen::Vector3d>;

constexpr double kSame = 1e-9;  // [m]

std::vector<Corners> polygons_of(const Extrusion& extrusion) {
  std::vector<Corners> polygons(2);
  const std::size_t n = extrusion.outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d& a = extrusion.outline[i];
    const Eigen::Vector2d& b = extrusion.outline[(i + 1) % n];
    polygons[0].emplace_back(a.x(), a.y(), extrusion.top);
    const Eigen::Vector2d& back = extrusion.outline[n - 1 - i];
    polygons[1].emplace_back(back.x(), back.y(), extrusion.bottom);
    polygons.push_back({{a.x(), a.y(), extrusion.bottom},
                        {b.x(), b.y(), extrusion.bottom},
                        {b.x(), b.y(), extrusion.top},
                        {a.x(), a.y(), extrusion.top}});
  }
  return polygons;
}

// Counter-clockwise, seen from outside.
std::vector<Corners> polygons_of(const Geometry& geometry) {
  if (const auto* extrusion = std::get_if<Extrusion>(&geometry)) return polygons_of(*extrusion);
  const auto* box = std::get_if<Box>(&geometry);
  if (box == nullptr) return {};
  const Eigen::Vector3d half = box->size / 2.0;
  const Eigen::Vector2d h = half.head<2>();
  return polygons_of(Extrusion{
      {{-h.x(), -h.y()}, {h.x(), -h.y()}, {h.x(), h.y()}, {-h.x(), h.y()}}, -half.z(), half.z()});
}

// Twice the area, along the normal (Newell).
Eigen::Vector3d area_vector(const Corners& corners) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += corners[i].cross(corners[(i + 1) % corners.size()]);
  }
  return sum;
}

MirrorFace face_of(const Corners& corners, const Eigen::Vector3d& normal) {
  MirrorFace face;
  face.normal = normal;
  face.offset = normal.dot(corners[0]);
  face.across = (corners[1] - corners[0]).normalized();
  face.along = normal.cross(face.across);
  for (const Eigen::Vector3d& corner : corners) {
    face.outline.emplace_back(corner.dot(face.across), corner.dot(face.along));
    face.box.extend(face.outline.back());
  }
  face.is_box =
      std::all_of(face.outline.begin(), face.outline.end(), [&](const Eigen::Vector2d& corner) {
        return (corner - face.box.min()).cwiseMin(face.box.max() - corner).cwiseAbs().maxCoeff() <
               kSame;
      });
  return face;
}

bool stands_still(const Entity& entity) {
  return entity.kind != EntityKind::door && entity.kind != EntityKind::movable;
}

}  // namespace

std::vector<MirrorFace> mirror_faces(const World& world, const MirrorFaceOptions& options) {
  std::vector<MirrorFace> faces;
  for (std::size_t id = 0; id < world.entities.size(); ++id) {
    const Entity& entity = world.entities[id];
    if (!stands_still(entity)) continue;
    if (entity.kind == EntityKind::floor && !options.floor) continue;
    for (const Part& part : entity.parts) {
      const Pose3 world_from_part = entity.world_from_entity * part.entity_from_part;
      for (Corners& corners : polygons_of(part.geometry)) {
        for (Eigen::Vector3d& corner : corners) corner = world_from_part * corner;
        const Eigen::Vector3d area = area_vector(corners);
        if (area.norm() < options.smallest * options.smallest) continue;
        MirrorFace face = face_of(corners, area.normalized());
        if (face.box.sizes().minCoeff() < options.smallest) continue;
        face.entity = static_cast<int>(id);
        face.material = part.material;
        faces.push_back(std::move(face));
      }
    }
  }
  return faces;
}

double height_over(const MirrorFace& face, const Eigen::Vector3d& point) {
  return face.normal.dot(point) - face.offset;
}

Eigen::Vector3d mirrored(const MirrorFace& face, const Eigen::Vector3d& point) {
  return point - 2.0 * height_over(face, point) * face.normal;
}

// Counts how often a ray to the right crosses the outline.
bool contains(const MirrorFace& face, const Eigen::Vector3d& point) {
  const double x = point.dot(face.across);
  const double y = point.dot(face.along);
  if (!face.box.contains(Eigen::Vector2d(x, y))) return false;
  if (face.is_box) return true;
  bool is_inside = false;
  for (std::size_t i = 0, j = face.outline.size() - 1; i < face.outline.size(); j = i++) {
    const Eigen::Vector2d& a = face.outline[i];
    const Eigen::Vector2d& b = face.outline[j];
    if ((a.y() > y) == (b.y() > y)) continue;
    if (x < a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y())) is_inside = !is_inside;
  }
  return is_inside;
}

}  // namespace mapbed
