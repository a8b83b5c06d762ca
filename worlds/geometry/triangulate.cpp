#include "worlds/geometry/triangulate.h"

#include <cmath>
#include <numeric>

#include <Eigen/Geometry>

namespace mapbed {
namespace {

using Corners = std::vector<Eigen::Vector2d>;

// Twice the area of abc; positive: c lies to the left of ab.
double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool is_ear(const Corners& p, const std::vector<std::uint32_t>& ring, std::size_t at) {
  const std::size_t n = ring.size();
  const std::uint32_t a = ring[(at + n - 1) % n];
  const std::uint32_t b = ring[at];
  const std::uint32_t c = ring[(at + 1) % n];
  if (cross(p[a], p[b], p[c]) <= 0.0) return false;
  for (const std::uint32_t i : ring) {
    if (i == a || i == b || i == c) continue;
    if (p[i] == p[a] || p[i] == p[b] || p[i] == p[c]) continue;  // the ends of a seam
    if (cross(p[a], p[b], p[i]) >= 0.0 && cross(p[b], p[c], p[i]) >= 0.0 &&
        cross(p[c], p[a], p[i]) >= 0.0) {
      return false;
    }
  }
  return true;
}

// Twice the area, along the normal (Newell's method: also of faces that are bent a little).
Eigen::Vector3d doubled_area_vector(const std::vector<Eigen::Vector3d>& corners) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d a = corners[i] - corners[0];
    sum += a.cross(corners[(i + 1) % corners.size()] - corners[0]);
  }
  return sum;
}

// The face without the coordinate in which it extends least, counter-clockwise.
Corners projected(const std::vector<Eigen::Vector3d>& corners, const Eigen::Vector3d& normal) {
  Eigen::Index z = 0;
  normal.cwiseAbs().maxCoeff(&z);
  Eigen::Index x = (z + 1) % 3;
  Eigen::Index y = (z + 2) % 3;
  if (normal[z] < 0.0) std::swap(x, y);
  Corners outline;
  for (const Eigen::Vector3d& corner : corners) outline.emplace_back(corner[x], corner[y]);
  return outline;
}

// Turns left at every corner, once round.
bool is_convex(const Corners& outline) {
  double turn = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
    const Eigen::Vector2d& c = outline[(i + 2) % outline.size()];
    const double area = cross(outline[i], b, c);
    if (area < 0.0) return false;
    turn += std::atan2(area, (b - outline[i]).dot(c - b));
  }
  return turn < 7.0;  // 2 pi; twice round is 4 pi
}

bool crosses_itself(const Corners& p) {
  const auto cross_each_other = [&p](std::size_t i, std::size_t k) {
    const Eigen::Vector2d& a = p[i];
    const Eigen::Vector2d& b = p[(i + 1) % p.size()];
    const Eigen::Vector2d& c = p[k];
    const Eigen::Vector2d& d = p[(k + 1) % p.size()];
    return cross(a, b, c) * cross(a, b, d) < 0.0 && cross(c, d, a) * cross(c, d, b) < 0.0;
  };
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t k = i + 2; k < p.size(); ++k) {
      if (cross_each_other(i, k)) return true;
    }
  }
  return false;
}

CornerTriangles fan(std::size_t corners) {
  CornerTriangles triangles;
  for (std::uint32_t i = 1; i + 1 < corners; ++i) triangles.push_back({0, i, i + 1});
  return triangles;
}

}  // namespace

double doubled_area(const Corners& outline) {
  double sum = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return sum;
}

CornerTriangles triangulate(const Corners& outline) {
  CornerTriangles triangles;
  std::vector<std::uint32_t> ring(outline.size());
  std::iota(ring.begin(), ring.end(), 0u);
  while (ring.size() >= 3) {
    const std::size_t n = ring.size();
    std::size_t ear = 0;
    while (ear < n && !is_ear(outline, ring, ear)) ++ear;
    if (ear == n) {
      // Only flat corners are left, or the polygon crosses itself: a flat one covers nothing.
      for (ear = 0; ear < n; ++ear) {
        if (cross(outline[ring[(ear + n - 1) % n]], outline[ring[ear]],
                  outline[ring[(ear + 1) % n]]) == 0.0) {
          break;
        }
      }
      if (ear == n) break;
    } else {
      triangles.push_back({ring[(ear + n - 1) % n], ring[ear], ring[(ear + 1) % n]});
    }
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return triangles;
}

std::optional<CornerTriangles> triangulate_face(const std::vector<Eigen::Vector3d>& corners) {
  double extent = 0.0;
  for (const Eigen::Vector3d& p : corners) extent = std::max(extent, (p - corners[0]).norm());
  const Eigen::Vector3d normal = doubled_area_vector(corners);
  if (!(normal.norm() > 1e-12 * extent * extent)) return CornerTriangles{};
  const Corners outline = projected(corners, normal);
  if (is_convex(outline)) return fan(outline.size());
  if (outline.size() > kMostCorners || crosses_itself(outline)) return std::nullopt;
  CornerTriangles triangles = triangulate(outline);
  const double area = doubled_area(outline);
  double covered = 0.0;
  for (const auto& [a, b, c] : triangles) covered += cross(outline[a], outline[b], outline[c]);
  if (std::abs(covered - area) > 1e-6 * area) return std::nullopt;
  return triangles;
}

}  // namespace mapbed
