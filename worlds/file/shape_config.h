#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/config/config_node.h"
#include "worlds/build/building.h"
#include "worlds/geometry/shape.h"

namespace mapbed {

// Pieces of a world file (worlds/file/world_file.h). All throw InputError with the place.

Eigen::Vector2d point(const ConfigNode& node);  // [x, y]
std::vector<Eigen::Vector2d> points(const ConfigNode& node, std::size_t least);
double length(const ConfigNode& map, const std::string& key, double otherwise);  // [m] > 0

// at: [x, y] or [x, y, z]; heading, pitch, roll.
Pose3 pose_of(const ConfigNode& node);

struct ConfiguredShape {
  Geometry geometry;
  double rise = 0.0;  // [m] of the geometry's origin over the shape's foot
};
// box, cylinder, outline or mesh; `height` for an outline that says none, `folder` of the mesh.
ConfiguredShape shape_of(const ConfigNode& node, double height,
                         const std::filesystem::path& folder);

Opening opening_of(const ConfigNode& node);

}  // namespace mapbed
