#include "worlds/geometry/shape.h"

#include <gtest/gtest.h>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

// By the divergence theorem: right only where every face is there and looks outwards.
double volume_of(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c])) / 6.0;
  }
  return sum;
}

TEST(MeshOf, ABoxEnclosesItsVolume) {
  EXPECT_NEAR(volume_of(mesh_of(Box{{2.0, 3.0, 4.0}})), 24.0, 1e-12);
}

TEST(MeshOf, AnExtrusionOfAnLKeepsItsNotchFree) {
  const Extrusion l{{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}}, 0.5, 2.5};
  EXPECT_NEAR(volume_of(mesh_of(l)), 4.0 * 2.0, 1e-12);
}

TEST(MeshOf, AnExtrusionMayHaveCornersOnAStraightLine) {
  const Extrusion wall{{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}}, 0.0, 1.0};
  EXPECT_NEAR(volume_of(mesh_of(wall)), 2.0, 1e-12);
}

TEST(MeshOf, ACylinderIsOffByNoMoreThanItsTolerance) {
  const double tolerance = 1e-4;
  const double volume = volume_of(mesh_of(Cylinder{0.5, 2.0}, tolerance));
  const double true_volume = kPi * 0.25 * 2.0;
  EXPECT_LT(volume, true_volume);
  EXPECT_GT(volume, true_volume - 2.0 * kPi * 0.5 * tolerance * 2.0);
}

}  // namespace
}  // namespace mapbed
