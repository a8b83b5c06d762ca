#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace mapbed {

// Twice the area inside, positive where the corners run counter-clockwise.
double doubled_area(const std::vector<Eigen::Vector2d>& outline);

// Triangles over the corners of a simple polygon that runs counter-clockwise; ear clipping, O(n^2).
// A polygon that crosses itself gives fewer triangles than n - 2.
std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<Eigen::Vector2d>& outline);

}  // namespace mapbed
