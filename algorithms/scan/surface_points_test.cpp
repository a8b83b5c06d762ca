#include "algorithms/scan/surface_points.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/testing/test_room.h"

namespace mapbed {
namespace {

constexpr double kMaxGap = 0.2, kSpacing = 0.05;  // [m]

std::vector<SurfacePoint> surface_of(const TestRoom& room) {
  return surface_points(scan_of(room, {}), 30.0, kMaxGap, kSpacing);
}

// How far the next point along x lies at most, of the points between two x and above y = 0 [m].
double widest_gap(const std::vector<SurfacePoint>& surface, double from, double to) {
  std::vector<double> x;
  for (const SurfacePoint& point : surface) {
    const Eigen::Vector2d& p = point.position;
    if (p.y() > 0.0 && p.x() >= from && p.x() <= to) x.push_back(p.x());
  }
  std::sort(x.begin(), x.end());
  double widest = x.empty() ? to - from : std::max(x.front() - from, to - x.back());
  for (std::size_t i = 1; i < x.size(); ++i) widest = std::max(widest, x[i] - x[i - 1]);
  return widest;
}

TEST(SurfacePoints, FillAWallThatIsSeenAtAGrazingAngle) {
  EXPECT_LE(widest_gap(surface_of(corridor(60.0)), 0.5, 7.0), kSpacing + 1e-9);
}

TEST(SurfacePoints, LeaveADoorOpen) {
  const TestRoom two_walls({{{0.0, 1.0}, {1.5, 1.0}}, {{2.5, 1.0}, {5.0, 1.0}}});
  EXPECT_GT(widest_gap(surface_of(two_walls), 0.5, 4.0), 0.9);
}

TEST(SurfacePoints, KnowTheLineOfASparseWallUpToItsLastHit) {
  const std::vector<SurfacePoint> surface = surface_of(corridor(60.0));
  const auto last = std::max_element(
      surface.begin(), surface.end(),
      [](const SurfacePoint& a, const SurfacePoint& b) { return a.position.x() < b.position.x(); });
  EXPECT_NEAR(std::abs(tangent_of(last->doubled).x()), 1.0, 1e-6);
}

}  // namespace
}  // namespace mapbed
