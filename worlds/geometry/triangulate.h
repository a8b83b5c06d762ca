#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace mapbed {

// Of a polygon that is triangulated: ear clipping takes up to O(n^3).
inline constexpr std::size_t kMostCorners = 500;

// Twice the area inside, positive where the corners run counter-clockwise.
double doubled_area(const std::vector<Eigen::Vector2d>& outline);

using CornerTriangles = std::vector<std::array<std::uint32_t, 3>>;

// Triangles over the corners of a simple polygon that runs counter-clockwise, by ear clipping. It
// may touch itself, as where a seam leads to a hole. One that crosses itself gives fewer triangles
// than n - 2.
CornerTriangles triangulate(const std::vector<Eigen::Vector2d>& outline);

// The same of a face in space, convex or not, whose corners lie near one plane; seen along its
// normal. None where the face covers nothing; no value where it is not convex and crosses itself or
// has more than kMostCorners.
std::optional<CornerTriangles> triangulate_face(const std::vector<Eigen::Vector3d>& corners);

}  // namespace mapbed
