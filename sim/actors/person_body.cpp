#include "sim/actors/person_body.h"

namespace mapbed {
namespace {

constexpr double kLegRadius = 0.07;    // [m]
constexpr double kHip = 0.85;          // [m]
constexpr double kTrunkRadius = 0.18;  // [m]
constexpr double kTop = 1.75;          // [m]

}  // namespace

Pose3 entity_from_leg(const Eigen::Vector2d& leg) {
  return upright({leg.x(), leg.y(), 0.0}, kHip / 2.0);
}

Entity person_entity(const std::string& name, const PersonView& person, int material) {
  const Cylinder leg{.radius = kLegRadius, .height = kHip};
  const Cylinder trunk{.radius = kTrunkRadius, .height = kTop - kHip};
  Entity entity;
  entity.name = name;
  entity.kind = EntityKind::person;
  entity.world_from_entity = upright(person.pose);
  entity.parts = {{"left leg", leg, entity_from_leg(person.legs[0]), material},
                  {"right leg", leg, entity_from_leg(person.legs[1]), material},
                  {"trunk", trunk, upright({}, (kHip + kTop) / 2.0), material}};
  return entity;
}

}  // namespace mapbed
