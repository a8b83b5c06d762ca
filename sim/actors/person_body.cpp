#include "sim/actors/person_body.h"

namespace mapbed {
namespace {

constexpr double kLegRadius = 0.07;    // [m]
constexpr double kHip = 0.85;          // [m]
constexpr double kTrunkRadius = 0.18;  // [m]
constexpr double kTop = 1.75;          // [m]

Pose3 body_from_leg(const Eigen::Vector2d& leg) {
  return upright({leg.x(), leg.y(), 0.0}, kHip / 2.0);
}

Pose3 body_from_trunk() {
  return upright({}, (kHip + kTop) / 2.0);
}

}  // namespace

Entity person_entity(const std::string& name, const PersonPosture& posture, int material) {
  const Cylinder leg{.radius = kLegRadius, .height = kHip};
  const Cylinder trunk{.radius = kTrunkRadius, .height = kTop - kHip};
  Entity entity;
  entity.name = name;
  entity.kind = EntityKind::person;
  entity.world_from_entity = upright(posture.world_from_body);
  entity.parts = {{"left leg", leg, body_from_leg(posture.legs[0]), material},
                  {"right leg", leg, body_from_leg(posture.legs[1]), material},
                  {"trunk", trunk, body_from_trunk(), material}};
  return entity;
}

std::array<Pose3, 3> part_poses(const PersonPosture& posture) {
  const Pose3 world_from_body = upright(posture.world_from_body);
  return {world_from_body * body_from_leg(posture.legs[0]),
          world_from_body * body_from_leg(posture.legs[1]), world_from_body * body_from_trunk()};
}

}  // namespace mapbed
