#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sim/scene/analytic.h"
#include "sim/scene/placed_part.h"

namespace mapbed {

// Boxes and cylinders are met analytically, everything else as triangles.
bool is_analytic(const Geometry& geometry);

// An analytic part with the motion into its frame ready.
class Solid {
 public:
  explicit Solid(const PlacedPart& placed);
  void place(const Pose3& world_from_part, bool visible);

  const PlacedPart& placed() const { return placed_; }
  Eigen::Vector3d center() const { return placed_.world_from_part.position; }
  Eigen::Vector3d half_extent() const;  // of the box around it, along the world's axes
  std::optional<Crossing> first_crossing(const Ray& ray) const;  // all in the world frame

 private:
  PlacedPart placed_;
  Eigen::Matrix3d part_from_world_;
  bool is_round_ = false;  // an upright cylinder: turning about z changes nothing
};

struct Plane {  // normal . p = offset
  Eigen::Vector3d normal;
  double offset;
};

// Triangles with their planes in double precision.
struct Triangles {
  std::vector<float> corners;  // x, y, z of three corners a triangle, none shared
  std::vector<Plane> planes;
  std::vector<int> owners;  // what the caller calls the part

  void add(const TriangleMesh& mesh, const Pose3& frame_from_mesh, int owner);
};

// Where the ray meets a triangle's plane; `about` is the range that single precision found, kept
// where the ray runs within the plane.
Crossing crossing_with(const Plane& plane, const Ray& ray, double about);

}  // namespace mapbed
