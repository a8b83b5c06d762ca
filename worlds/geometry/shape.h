#pragma once

#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/pose3.h"
#include "core/geometry/triangle_mesh.h"

namespace mapbed {

// Solid shapes in their own frame. [m]

struct Box {  // centred on the origin
  Eigen::Vector3d size = {1.0, 1.0, 1.0};
};
struct Cylinder {  // axis z, centred on the origin
  double radius = 0.5;
  double height = 1.0;
};
struct Extrusion {                            // a plan pulled up
  std::vector<Eigen::Vector2d> outline = {};  // simple polygon, counter-clockwise
  double bottom = 0.0;
  double top = 2.5;
};
using Geometry = std::variant<Box, Cylinder, Extrusion, TriangleMesh>;

// One piece of an entity: a table's leg, a person's left leg.
struct Part {
  std::string name = {};
  Geometry geometry = {};
  Pose3 entity_from_part = {};
  int material = 0;  // index into the world's materials
};

// movable: what people move about, unlike furniture, which stays where it is.
enum class EntityKind : int {
  structure,
  floor,
  furniture,
  door,
  person,
  robot,
  vehicle,
  plant,
  movable
};

// One thing with a name, of one or more parts; moves as a whole.
struct Entity {
  std::string name = {};
  EntityKind kind = EntityKind::structure;
  Pose3 world_from_entity = {};
  std::vector<Part> parts = {};
};

std::string name_of(EntityKind kind);

// As triangles in the part's own frame. Circles become polygons whose corners lie on the circle and
// whose sides are off by at most `tolerance`; everything else is exact.
TriangleMesh mesh_of(const Geometry& geometry, double tolerance = 0.001);

}  // namespace mapbed
