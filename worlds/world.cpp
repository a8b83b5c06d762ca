#include "worlds/world.h"

#include <cmath>

#include "core/check.h"
#include "core/config/suggestion.h"
#include "core/input_error.h"

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

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& things) {
  std::vector<std::string> names;
  for (const Named& thing : things) names.push_back(thing.name);
  return names;
}

template <class Named>
std::size_t index_by_name(const std::vector<Named>& things, const std::string& name,
                          const std::string& what) {
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (things[i].name == name) return i;
  }
  throw InputError("unknown " + what + " '" + name + "'; " + suggestion(name, names_of(things)));
}

}  // namespace

Eigen::AlignedBox3d bounds_of(const World& world) {
  Eigen::AlignedBox3d box;
  for (const Entity& entity : world.entities) extend(box, entity);
  return box;
}

int material_index(const World& world, const std::string& name) {
  return static_cast<int>(index_by_name(world.materials, name, "material"));
}

const NamedPath& path_by_name(const World& world, const std::string& name) {
  return world.paths[index_by_name(world.paths, name, "path in world '" + world.name + "'")];
}

Pose2 start_of(const NamedPath& path) {
  CHECK(path.points.size() >= 2);
  const Eigen::Vector2d& from = path.points[0].position;
  const Eigen::Vector2d way = path.points[1].position - from;
  return {from.x(), from.y(), std::atan2(way.y(), way.x())};
}

}  // namespace mapbed
