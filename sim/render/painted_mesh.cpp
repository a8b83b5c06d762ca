#include "sim/render/painted_mesh.h"

#include <algorithm>
#include <cmath>

namespace mapbed {
namespace {

constexpr double kRoundness = 0.0005;  // [m] by which a drawn cylinder may be off
constexpr double kCutEdge = 0.35;      // brightness of what is cut open
constexpr double kGlassOpacity = 0.35;

std::array<float, 3> floats(const Eigen::Vector3d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

struct Paint {
  Eigen::Vector3d color;
  double opacity = 1.0;
};

void add_triangle(std::vector<PaintedVertex>& target, const std::array<Eigen::Vector3d, 3>& corners,
                  const std::array<Eigen::Vector3d, 3>& normals, const Paint& paint) {
  const std::array<float, 3> rgb = floats(paint.color);
  for (std::size_t i = 0; i < 3; ++i) {
    target.push_back({floats(corners[i]),
                      floats(normals[i]),
                      {rgb[0], rgb[1], rgb[2], static_cast<float>(paint.opacity)}});
  }
}

void add_shining(std::vector<PaintedVertex>& target, const Eigen::Vector3d& a,
                 const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Paint& paint) {
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  add_triangle(target, {a, b, c}, {none, none, none}, paint);
}

// The part without what is higher than the cut; false where nothing is left. Only what stands
// upright is cut.
bool cut_down(Geometry& geometry, Pose3& world_from_part, double cut) {
  const Eigen::Vector3d up = world_from_part.rotation * Eigen::Vector3d::UnitZ();
  if (up.z() < 0.999) return true;
  const double z = world_from_part.position.z();
  if (auto* extrusion = std::get_if<Extrusion>(&geometry)) {
    extrusion->top = std::min(extrusion->top, cut - z);
    return extrusion->top > extrusion->bottom;
  }
  auto* box = std::get_if<Box>(&geometry);
  auto* cylinder = std::get_if<Cylinder>(&geometry);
  if (box == nullptr && cylinder == nullptr) return true;
  double& height = box != nullptr ? box->size.z() : cylinder->height;
  const double bottom = z - height / 2;
  const double top = std::min(z + height / 2, cut);
  if (top <= bottom) return false;
  height = top - bottom;
  world_from_part.position.z() = (bottom + top) / 2;
  return true;
}

bool ends_at_cut(const std::array<Eigen::Vector3d, 3>& corners, double cut) {
  return std::all_of(corners.begin(), corners.end(),
                     [&](const auto& p) { return std::abs(p.z() - cut) < 1e-6; });
}

// Round about the axis, flat at the ends.
Eigen::Vector3d cylinder_normal(const Eigen::Vector3d& corner, const Eigen::Vector3d& flat) {
  if (std::abs(flat.z()) > 0.5) return flat;
  return Eigen::Vector3d(corner.x(), corner.y(), 0.0).normalized();
}

}  // namespace

void paint(PaintedMesh& mesh, const Entity& entity, const std::vector<Material>& materials,
           const PaintOptions& options) {
  const bool is_cut = options.cut_height > 0.0 &&
                      (entity.kind == EntityKind::structure || entity.kind == EntityKind::door);
  for (const Part& part : entity.parts) {
    Geometry geometry = part.geometry;
    Pose3 world_from_part = entity.world_from_entity * part.entity_from_part;
    if (is_cut && !cut_down(geometry, world_from_part, options.cut_height)) continue;
    const Material& material = materials[static_cast<std::size_t>(part.material)];
    const bool is_clear = material.transmittance > 0.0;
    const bool is_round = std::holds_alternative<Cylinder>(geometry);
    const TriangleMesh shape = mesh_of(geometry, kRoundness);
    for (const auto& [a, b, c] : shape.triangles) {
      const std::array<Eigen::Vector3d, 3> local = {shape.vertices[a], shape.vertices[b],
                                                    shape.vertices[c]};
      const Eigen::Vector3d flat = (local[1] - local[0]).cross(local[2] - local[0]).normalized();
      std::array<Eigen::Vector3d, 3> corners, normals;
      for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = world_from_part * local[i];
        normals[i] = world_from_part.rotation * (is_round ? cylinder_normal(local[i], flat) : flat);
      }
      Paint paint{material.color, is_clear ? kGlassOpacity : 1.0};
      if (is_cut && ends_at_cut(corners, options.cut_height)) paint.color *= kCutEdge;
      add_triangle(is_clear ? mesh.clear : mesh.opaque, corners, normals, paint);
    }
  }
}

void paint(PaintedMesh& mesh, const LaserFan& fan) {
  constexpr double kSpark = 0.025;  // [m]
  for (std::size_t i = 0; i + 1 < fan.ends.size(); ++i) {
    add_shining(mesh.clear, fan.origin, fan.ends[i], fan.ends[i + 1], {fan.color, 0.22});
  }
  for (std::size_t i = 0; i < fan.ends.size(); ++i) {
    if (!fan.is_hit[i]) continue;
    const TriangleMesh spark = mesh_of(Box{Eigen::Vector3d::Constant(2 * kSpark)});
    for (const auto& [a, b, c] : spark.triangles) {
      add_shining(mesh.opaque, fan.ends[i] + spark.vertices[a], fan.ends[i] + spark.vertices[b],
                  fan.ends[i] + spark.vertices[c], {fan.color});
    }
  }
}

void paint(PaintedMesh& mesh, const RfidTag& tag) {
  const Paint magenta{{0.85, 0.10, 0.60}};
  const TriangleMesh plate = mesh_of(Box{{0.08, 0.16, 0.16}});
  for (const auto& [a, b, c] : plate.triangles) {
    add_shining(mesh.opaque, tag.world_from_tag * plate.vertices[a],
                tag.world_from_tag * plate.vertices[b], tag.world_from_tag * plate.vertices[c],
                magenta);
  }
}

void paint_line(PaintedMesh& mesh, const std::vector<Eigen::Vector3d>& points, double width,
                const Eigen::Vector3d& color) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Eigen::Vector3d way = points[i + 1] - points[i];
    if (way.norm() == 0.0) continue;
    const Eigen::Vector3d ahead = way.normalized() * width / 2;
    const Eigen::Vector3d left(-ahead.y(), ahead.x(), 0.0);
    const Eigen::Vector3d from = points[i] - ahead;
    const Eigen::Vector3d to = points[i + 1] + ahead;
    add_shining(mesh.opaque, from - left, to - left, to + left, {color});
    add_shining(mesh.opaque, from - left, to + left, from + left, {color});
  }
}

}  // namespace mapbed
