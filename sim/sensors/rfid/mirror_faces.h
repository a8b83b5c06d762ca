#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "worlds/world.h"

namespace mapbed {

// A plane piece of a thing's surface, which mirrors waves.
struct MirrorFace {
  int entity = 0;
  int material = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // unit, out of the thing
  double offset = 0.0;                                // [m] normal . p of its points
  Eigen::Vector3d across = Eigen::Vector3d::UnitX();  // unit, in the plane, as ...
  Eigen::Vector3d along = Eigen::Vector3d::UnitY();   // ... this one is
  std::vector<Eigen::Vector2d> outline = {};          // [m] by across and along, convex or not
  Eigen::AlignedBox2d box = {};                       // around the outline
  bool is_box = false;                                // ... and nothing but it
};

struct MirrorFaceOptions {
  double smallest = 0.33;  // [m] a face that is narrower does not count
  bool floor = true;

  friend bool operator==(const MirrorFaceOptions&, const MirrorFaceOptions&) = default;
};

// Of boxes and extrusions that stand still: door leaves and movables are none.
std::vector<MirrorFace> mirror_faces(const World& world, const MirrorFaceOptions& options);

double height_over(const MirrorFace& face, const Eigen::Vector3d& point);  // [m]
Eigen::Vector3d mirrored(const MirrorFace& face, const Eigen::Vector3d& point);
bool contains(const MirrorFace& face, const Eigen::Vector3d& point);  // of a point of its plane

}  // namespace mapbed
