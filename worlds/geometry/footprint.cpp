#include "worlds/geometry/footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "worlds/geometry/triangulate.h"

namespace mapbed {
namespace {

using Points2 = std::vector<Eigen::Vector2d>;
using Points3 = std::vector<Eigen::Vector3d>;

constexpr double kUpright = 1e-9;  // what the z axis may lean [rad]

bool is_upright(const Pose3& world_from_part) {
  const Eigen::Vector3d up = world_from_part.rotation * Eigen::Vector3d::UnitZ();
  return std::abs(up.x()) < kUpright && std::abs(up.y()) < kUpright && up.z() > 0.0;
}

// The corners of a polygon in space that lie on one side of a height, new ones on it included.
Points3 clipped(const Points3& corners, double height, bool keep_above) {
  Points3 kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d& a = corners[i];
    const Eigen::Vector3d& b = corners[(i + 1) % corners.size()];
    const double above_a = keep_above ? a.z() - height : height - a.z();
    const double above_b = keep_above ? b.z() - height : height - b.z();
    if (above_a >= 0.0) kept.push_back(a);
    if ((above_a > 0.0 && above_b < 0.0) || (above_a < 0.0 && above_b > 0.0)) {
      kept.push_back(a + (b - a) * (above_a / (above_a - above_b)));
    }
  }
  return kept;
}

Points2 seen_from_above(const Points3& corners) {
  Points2 outline;
  for (const Eigen::Vector3d& corner : corners) outline.push_back(corner.head<2>());
  const double area = doubled_area(outline);
  if (std::abs(area) < 1e-12) {  // stands upright: keep the two ends
    const auto [low, high] = std::minmax_element(
        outline.begin(), outline.end(),
        [](const auto& a, const auto& b) { return a.x() + 1e-3 * a.y() < b.x() + 1e-3 * b.y(); });
    return {*low, *high};
  }
  if (area < 0.0) std::reverse(outline.begin(), outline.end());
  return outline;
}

void add_mesh(std::vector<Footprint>& footprints, const Footprint& named, const TriangleMesh& mesh,
              const Pose3& world_from_mesh, double low, double high) {
  for (const auto& [a, b, c] : mesh.triangles) {
    const Points3 corners = {world_from_mesh * mesh.vertices[a], world_from_mesh * mesh.vertices[b],
                             world_from_mesh * mesh.vertices[c]};
    const Points3 within = clipped(clipped(corners, low, true), high, false);
    if (within.size() < 3) continue;
    footprints.push_back(named);
    footprints.back().outline = seen_from_above(within);
  }
}

void add_upright(std::vector<Footprint>& footprints, Footprint named, const Points2& outline,
                 double bottom, double top, const Pose3& world_from_part, double low, double high) {
  const double z = world_from_part.position.z();
  if (z + top <= low || z + bottom >= high) return;
  for (const Eigen::Vector2d& p : outline) {
    named.outline.push_back((world_from_part * Eigen::Vector3d(p.x(), p.y(), 0.0)).head<2>());
  }
  footprints.push_back(std::move(named));
}

void add_part(std::vector<Footprint>& footprints, const Footprint& named, const Geometry& geometry,
              const Pose3& world_from_part, double low, double high) {
  if (is_upright(world_from_part)) {
    if (const auto* box = std::get_if<Box>(&geometry)) {
      const double x = box->size.x() / 2, y = box->size.y() / 2, z = box->size.z() / 2;
      add_upright(footprints, named, {{-x, -y}, {x, -y}, {x, y}, {-x, y}}, -z, z, world_from_part,
                  low, high);
      return;
    }
    if (const auto* extrusion = std::get_if<Extrusion>(&geometry)) {
      add_upright(footprints, named, extrusion->outline, extrusion->bottom, extrusion->top,
                  world_from_part, low, high);
      return;
    }
    if (const auto* cylinder = std::get_if<Cylinder>(&geometry)) {
      const double z = world_from_part.position.z();
      if (z + cylinder->height / 2 <= low || z - cylinder->height / 2 >= high) return;
      footprints.push_back(named);
      footprints.back().center = world_from_part.position.head<2>();
      footprints.back().radius = cylinder->radius;
      return;
    }
  }
  add_mesh(footprints, named, mesh_of(geometry), world_from_part, low, high);
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double point_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                        const Eigen::Vector2d& b) {
  const Eigen::Vector2d way = b - a;
  const double length2 = way.squaredNorm();
  const double fraction = length2 > 0.0 ? std::clamp((p - a).dot(way) / length2, 0.0, 1.0) : 0.0;
  return (p - a - fraction * way).norm();
}

bool segments_cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                    const Eigen::Vector2d& d) {
  return cross(b - a, c - a) * cross(b - a, d - a) < 0.0 &&
         cross(d - c, a - c) * cross(d - c, b - c) < 0.0;
}

double segment_to_segment(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                          const Eigen::Vector2d& c, const Eigen::Vector2d& d) {
  if (segments_cross(a, b, c, d)) return 0.0;
  return std::min({point_to_segment(a, c, d), point_to_segment(b, c, d), point_to_segment(c, a, b),
                   point_to_segment(d, a, b)});
}

// By the number of edges that a line to the right crosses.
bool is_inside(const Points2& outline, const Eigen::Vector2d& p) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

}  // namespace

std::vector<Footprint> footprints(const Entity& entity, int id, double low, double high) {
  std::vector<Footprint> result;
  for (std::size_t i = 0; i < entity.parts.size(); ++i) {
    const Part& part = entity.parts[i];
    const Footprint named{.entity = id, .part = static_cast<int>(i), .material = part.material};
    add_part(result, named, part.geometry, entity.world_from_entity * part.entity_from_part, low,
             high);
  }
  return result;
}

std::vector<Footprint> footprints(const World& world, double low, double high) {
  std::vector<Footprint> result;
  for (std::size_t id = 0; id < world.entities.size(); ++id) {
    const std::vector<Footprint> of_entity =
        footprints(world.entities[id], static_cast<int>(id), low, high);
    result.insert(result.end(), of_entity.begin(), of_entity.end());
  }
  return result;
}

bool covers(const Footprint& footprint, const Eigen::Vector2d& point) {
  if (footprint.outline.empty()) {
    return (point - footprint.center).norm() <= footprint.radius;
  }
  return is_inside(footprint.outline, point);
}

double distance_to(const Footprint& footprint, const Eigen::Vector2d& point) {
  return distance_to(footprint, point, point);
}

double distance_to(const Footprint& footprint, const Eigen::Vector2d& from,
                   const Eigen::Vector2d& to) {
  if (footprint.outline.empty()) {
    return std::max(0.0, point_to_segment(footprint.center, from, to) - footprint.radius);
  }
  if (is_inside(footprint.outline, from)) return 0.0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < footprint.outline.size(); ++i) {
    const Eigen::Vector2d& a = footprint.outline[i];
    const Eigen::Vector2d& b = footprint.outline[(i + 1) % footprint.outline.size()];
    nearest = std::min(nearest, segment_to_segment(from, to, a, b));
  }
  return nearest;
}

double distance_between(const Footprint& a, const Footprint& b) {
  if (b.outline.empty()) return std::max(0.0, distance_to(a, b.center) - b.radius);
  if (!a.outline.empty() && is_inside(b.outline, a.outline[0])) return 0.0;
  double nearest = std::numeric_limits<double>::infinity();
  if (a.outline.empty() && is_inside(b.outline, a.center)) return 0.0;
  for (std::size_t i = 0; i < b.outline.size(); ++i) {
    nearest =
        std::min(nearest, distance_to(a, b.outline[i], b.outline[(i + 1) % b.outline.size()]));
  }
  return nearest;
}

Eigen::AlignedBox2d bounds_of(const Footprint& footprint) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& corner : footprint.outline) box.extend(corner);
  if (footprint.outline.empty()) {
    const Eigen::Vector2d r = Eigen::Vector2d::Constant(footprint.radius);
    box.extend(Eigen::Vector2d(footprint.center - r));
    box.extend(Eigen::Vector2d(footprint.center + r));
  }
  return box;
}

}  // namespace mapbed
