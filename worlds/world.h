#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/geometry/pose2.h"
#include "worlds/geometry/material.h"
#include "worlds/geometry/shape.h"

namespace mapbed {

struct WayPoint {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m]
  double speed = 0.0;  // [m/s] on the way here; 0: as the robot likes
  double pause = 0.0;  // [s] spent here before going on
};

// Where a robot can be sent. Free of obstacles (doors open) for a disc of `clearance` about it.
struct NamedPath {
  std::string name = {};
  std::vector<WayPoint> points = {};  // two or more
  double clearance = 0.3;             // [m]
};

// A hinged leaf. The leaf is an entity of kind door whose frame has its origin at the hinge, on the
// floor, and the leaf along x; world_from_hinge is where that frame stands when the door is shut.
struct Door {
  std::string name = {};
  int entity = 0;               // index into World::entities
  Pose2 world_from_hinge = {};  // of the shut leaf
  double width = 0.9;           // [m]
  double open_angle = 1.6;      // [rad] positive: turns counter-clockwise
  double turn_speed = 1.2;      // [rad/s]
  bool starts_open = false;
  double mean_open = 0.0;     // [s] exponential; 0: stays as it is until somebody needs it
  double mean_shut = 0.0;     // [s] exponential; 0: as above
  double opens_within = 1.2;  // [m] opens for a person or robot that comes this near; 0: for nobody
};

// What is moved about: it rests, is moved straight to the next of its places (after the last one to
// the first), and rests again. Its entity, of kind movable, is none of World::entities.
struct Movable {
  Entity entity = {};                        // where it stands in the beginning
  std::vector<Eigen::Vector2d> places = {};  // [m] of its origin; the first is where it stands
  double speed = 0.5;                        // [m/s]
  double mean_rest = 20.0;                   // [s] exponential
};

struct CrowdRoute {
  std::string name = {};
  std::vector<Eigen::Vector2d> points = {};  // walked to and fro, or round where closed
  bool closed = false;
  double weight = 1.0;  // relative number of walkers
};
struct StandingPlace {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m]
  double heading = 0.0;                                // [rad] where to look
  double radius = 1.0;                                 // [m] people stand anywhere in this circle
};
struct CrowdRules {
  int walkers = 0;
  int standing = 0;
  int blockers = 0;             // step in the robot's way on purpose
  double pause_fraction = 0.3;  // probability to pause at a point of the route
  double mean_pause = 5.0;      // [s] exponential
  double group_fraction = 0.2;  // fraction of walkers who walk in pairs
  std::vector<CrowdRoute> routes = {};
  std::vector<StandingPlace> places = {};
};

// A passive tag. It looks along its x axis; its dipole lies along its y axis.
struct RfidTag {
  static constexpr int kNothing = -1;

  std::string id = {};  // one word
  Pose3 world_from_tag = {};
  int material = kNothing;  // that it sticks on, index into World::materials; or kNothing
};

// What there is, as data. An entity's id is its index here; whoever adds moving things (robots,
// people) numbers them on from entities.size().
struct World {
  std::string name = {};
  std::vector<Material> materials = standard_materials();
  std::vector<Entity> entities = {};
  std::vector<Door> doors = {};
  std::vector<Movable> movables = {};
  std::vector<NamedPath> paths = {};
  std::vector<RfidTag> tags = {};
  CrowdRules crowd;
  double ceiling = 2.8;  // [m] height of the rooms; walls end here, pictures look in from above
};

Eigen::AlignedBox3d bounds_of(const World& world);

// Of these names; throw InputError with the nearest one where there is none.
int material_index(const World& world, const std::string& name);
const NamedPath& path_by_name(const World& world, const std::string& name);

// Where a drive along the path starts: on its first point, looking to the second.
Pose2 start_of(const NamedPath& path);

}  // namespace mapbed
