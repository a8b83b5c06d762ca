#include "worlds/world.h"

namespace mapbed {
namespace {

void extend(Eigen::AlignedBox3d& box, const Entity& entity) {
  for (const Part& part : entity.parts) {
    const Pose3 world_from_part = entity.world_from_entity * part.entity_from_part;
    for (const Eigen::Vector3d& vertex : mesh_of(part.geometry).vertices) {
      box.extend(world_from_part * vertex);
    }
  }
}

}  // namespace

Eigen::AlignedBox3d bounds_of(const World& world) {
  Eigen::AlignedBox3d box;
  for (const Entity& entity : world.entities) extend(box, entity);
  return box;
}

}  // namespace mapbed
