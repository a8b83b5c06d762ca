#include "worlds/file/obj_file.h"

#include <cmath>
#include <string>

#include <Eigen/Geometry>
#include <gmock/gmock.h>

#include "core/geometry/triangle_mesh.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

TriangleMesh load(const std::string& text) {
  return parse_obj("a.obj", text);
}

double area_of(const TriangleMesh& mesh) {
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d ab = mesh.vertices[b] - mesh.vertices[a];
    area += 0.5 * ab.cross(mesh.vertices[c] - mesh.vertices[a]).norm();
  }
  return area;
}

// The teeth of a saw over a base line: a face of so many corners, an odd number.
std::string zigzag(int corners) {
  std::string text;
  for (int i = 0; i < corners - 2; ++i) {
    text += "v " + std::to_string(i) + " " + std::to_string(2 - i % 2) + " 0\n";
  }
  text += "v " + std::to_string(corners - 3) + " 0 0\nv 0 0 0\nf";
  for (int i = corners; i > 0; --i) text += " " + std::to_string(i);
  return text + "\n";
}

// Whether the ray along `direction` through `from` meets a triangle.
bool is_met(const TriangleMesh& mesh, const Eigen::Vector3d& from,
            const Eigen::Vector3d& direction) {
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto volume = [&](std::uint32_t p, std::uint32_t q) {
      return direction.dot((mesh.vertices[p] - from).cross(mesh.vertices[q] - from));
    };
    const double ab = volume(a, b), bc = volume(b, c), ca = volume(c, a);
    if ((ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0)) return true;
  }
  return false;
}

// A gate of 6 m x 3 m whose way through, 2 m x 2 m, goes down to the floor: one concave face,
// upright along x, and the same lying on a slope.
constexpr const char* kGate = "f 1 2 3 4 5 6 7 8\n";
constexpr const char* kUpright =
    "v 0 0 0\nv 2 0 0\nv 2 0 2\nv 4 0 2\nv 4 0 0\nv 6 0 0\nv 6 0 3\nv 0 0 3\n";
constexpr const char* kOnASlope =
    "v 0 0 0\nv 2 0 2\nv 2 2 2\nv 4 2 4\nv 4 0 4\nv 6 0 6\nv 6 3 6\nv 0 3 0\n";

TEST(ObjFile, LeavesTheWayThroughAConcaveFaceOpen) {
  const Eigen::Vector3d through(0.1, 1.0, 0.07);
  for (const char* order : {"f 1 2 3 4 5 6 7 8\n", "f 8 7 6 5 4 3 2 1\n", "f 5 6 7 8 1 2 3 4\n"}) {
    const TriangleMesh gate = load(std::string(kUpright) + order);
    EXPECT_NEAR(area_of(gate), 6.0 * 3.0 - 2.0 * 2.0, 1e-12) << order;
    EXPECT_FALSE(is_met(gate, {3.0, -2.0, 1.0}, through)) << order;
    EXPECT_TRUE(is_met(gate, {1.0, -2.0, 1.0}, through)) << order;
    EXPECT_TRUE(is_met(gate, {3.0, -2.0, 2.5}, through)) << order;
    EXPECT_TRUE(is_met(gate, {5.0, -2.0, 1.0}, through)) << order;
  }
  EXPECT_NEAR(area_of(load(std::string(kOnASlope) + kGate)), 14.0 * std::sqrt(2.0), 1e-12);
}

TEST(ObjFile, LeavesAHoleOpenToWhichASeamLeads) {
  // A square of 3 m with a hole of 1 m in its middle; the seam goes from corner 1 to corner 5.
  const TriangleMesh ring = load(
      "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\n"
      "f 1 2 3 4 1 5 6 7 8 5\n");
  EXPECT_NEAR(area_of(ring), 9.0 - 1.0, 1e-12);
  EXPECT_FALSE(is_met(ring, {1.5, 1.5, 1.0}, {0.01, 0.02, -1.0}));
  EXPECT_TRUE(is_met(ring, {0.5, 1.5, 1.0}, {0.01, 0.02, -1.0}));
}

TEST(ObjFile, KeepsTheSideThatAFaceLooksTo) {
  const TriangleMesh gate = load(std::string(kUpright) + kGate);
  for (const auto& [a, b, c] : gate.triangles) {
    const Eigen::Vector3d ab = gate.vertices[b] - gate.vertices[a];
    EXPECT_LT(ab.cross(gate.vertices[c] - gate.vertices[a]).y(), 0.0);  // x times z is -y
  }
}

TEST(ObjFile, TakesFacesThatAreBentALittleAndLeavesOutThoseThatCoverNothing) {
  const std::string bent = "v 0 0 0\nv 1 0 0.01\nv 1 1 0\nv 0 1 0.01\nf 1 2 3 4\n";
  EXPECT_EQ(load(bent).triangles.size(), 2u);
  EXPECT_EQ(load(bent + "f 1 2 1\nf 1 1 1\n").triangles.size(), 2u);
  EXPECT_INPUT_ERROR(load("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), "no face in it that covers");
}

TEST(ObjFile, RefusesAFaceThatCrossesItselfOrHasTooManyCorners) {
  EXPECT_INPUT_ERROR(load("v 0 0 0\nv 3 0 0\nv 0 1 0\nv 2 1 0\nf 1 2 3 4\n"),
                     "a.obj:5: the face crosses itself");
  std::string star;  // of five points, twice round: every corner turns the same way
  for (int i = 0; i < 5; ++i) {
    star += "v " + std::to_string(std::cos(2.5132741 * i)) + " " +
            std::to_string(std::sin(2.5132741 * i)) + " 0\n";
  }
  EXPECT_INPUT_ERROR(load(star + "f 1 2 3 4 5\n"), "a.obj:6: the face crosses itself");
  EXPECT_INPUT_ERROR(load(zigzag(501)), "has more than 500 corners and is not convex");
  EXPECT_EQ(load(zigzag(499)).triangles.size(), 497u);
}

TEST(ObjFile, CountsNegativeCornersBackFromTheVertexAbove) {
  const TriangleMesh mesh = load("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 8 8 8\n");
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.triangles[0], (std::array<std::uint32_t, 3>{1, 2, 3}));
  EXPECT_INPUT_ERROR(load("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 -2 -1\n"),
                     "face corner '-4' names no vertex above it");
}

}  // namespace
}  // namespace mapbed
