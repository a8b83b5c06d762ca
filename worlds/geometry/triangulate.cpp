#include "worlds/geometry/triangulate.h"

#include <numeric>

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
    if (cross(p[a], p[b], p[i]) >= 0.0 && cross(p[b], p[c], p[i]) >= 0.0 &&
        cross(p[c], p[a], p[i]) >= 0.0) {
      return false;
    }
  }
  return true;
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

std::vector<std::array<std::uint32_t, 3>> triangulate(const Corners& outline) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
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

}  // namespace mapbed
