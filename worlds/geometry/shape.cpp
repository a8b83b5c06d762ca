#include "worlds/geometry/shape.h"

#include <cmath>
#include <type_traits>

#include "core/check.h"
#include "core/geometry/angle.h"
#include "worlds/geometry/triangulate.h"

namespace mapbed {
namespace {

// A prism on a polygon that is counter-clockwise, with its own corners for top, bottom and sides.
TriangleMesh prism(const std::vector<Eigen::Vector2d>& outline, double bottom, double top) {
  const auto n = static_cast<std::uint32_t>(outline.size());
  TriangleMesh mesh;
  for (const double z : {bottom, top}) {
    for (const Eigen::Vector2d& p : outline) mesh.vertices.emplace_back(p.x(), p.y(), z);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    mesh.triangles.push_back({i, next, n + next});
    mesh.triangles.push_back({i, n + next, n + i});
  }
  for (const auto& [a, b, c] : triangulate(outline)) {
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({n + a, n + b, n + c});
  }
  return mesh;
}

std::vector<Eigen::Vector2d> rectangle(double width, double depth) {
  const double x = width / 2;
  const double y = depth / 2;
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

std::vector<Eigen::Vector2d> circle(double radius, double tolerance) {
  // The sagitta r (1 - cos(pi / n)) of a side is the tolerance.
  const double half_side = std::acos(1.0 - std::min(0.5, tolerance / radius));
  const int n = std::max(8, static_cast<int>(std::ceil(kPi / half_side)));
  std::vector<Eigen::Vector2d> corners;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * kPi * i / n;
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return corners;
}

}  // namespace

std::string name_of(EntityKind kind) {
  switch (kind) {
    case EntityKind::structure:
      return "structure";
    case EntityKind::floor:
      return "floor";
    case EntityKind::furniture:
      return "furniture";
    case EntityKind::door:
      return "door";
    case EntityKind::person:
      return "person";
    case EntityKind::robot:
      return "robot";
    case EntityKind::vehicle:
      return "vehicle";
    case EntityKind::plant:
      return "plant";
    case EntityKind::movable:
      return "movable";
  }
  CHECK(false && "an entity kind without a name");
}

TriangleMesh mesh_of(const Geometry& geometry, double tolerance) {
  return std::visit(
      [&](const auto& g) -> TriangleMesh {
        using T = std::decay_t<decltype(g)>;
        if constexpr (std::is_same_v<T, Box>) {
          return prism(rectangle(g.size.x(), g.size.y()), -g.size.z() / 2, g.size.z() / 2);
        } else if constexpr (std::is_same_v<T, Cylinder>) {
          return prism(circle(g.radius, tolerance), -g.height / 2, g.height / 2);
        } else if constexpr (std::is_same_v<T, Extrusion>) {
          return prism(g.outline, g.bottom, g.top);
        } else {
          return g;
        }
      },
      geometry);
}

}  // namespace mapbed
