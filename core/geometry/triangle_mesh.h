#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace mapbed {

// Corners run counter-clockwise seen from outside, so that normals point out.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;                // [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;  // indices into vertices
};

}  // namespace mapbed
