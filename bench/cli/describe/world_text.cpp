#include "bench/cli/describe/world_text.h"

#include <fmt/format.h>

#include "core/geometry/angle.h"
#include "worlds/world.h"

namespace mapbed {
namespace {

double length_of(const NamedPath& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    length += (path.points[i].position - path.points[i - 1].position).norm();
  }
  return length;
}

}  // namespace

std::string text_of_world(const World& world) {
  const Eigen::AlignedBox3d bounds = bounds_of(world);
  const Eigen::Vector3d size = bounds.sizes();
  std::string text = fmt::format(
      "size: {:.1f} m x {:.1f} m, from ({:.1f}, {:.1f}) to ({:.1f}, {:.1f})\nthings: {}, of them "
      "{} doors\npeople: {} walking, {} standing\n",
      size.x(), size.y(), bounds.min().x(), bounds.min().y(), bounds.max().x(), bounds.max().y(),
      world.entities.size(), world.doors.size(), world.crowd.walkers, world.crowd.standing);
  text += world.paths.empty() ? "paths: none\n" : "paths:\n";
  for (const NamedPath& path : world.paths) {
    const Eigen::Vector2d start = path.points.front().position;
    text += fmt::format("  - {}: {:.1f} m by {} points from ({:.1f}, {:.1f}), clear for {:g} m\n",
                        path.name, length_of(path), path.points.size(), start.x(), start.y(),
                        path.clearance);
  }
  if (!world.crowd.routes.empty()) text += "where people walk:\n";
  for (const CrowdRoute& route : world.crowd.routes) {
    const Eigen::Vector2d end = route.points.back();
    text += fmt::format("  - {}: to ({:.1f}, {:.1f})\n", route.name, end.x(), end.y());
  }
  if (!world.movables.empty()) text += "what is moved about:\n";
  for (const Movable& movable : world.movables) {
    const Eigen::Vector3d& at = movable.entity.world_from_entity.position;
    text += fmt::format("  - {}: at ({:.1f}, {:.1f}), {} further places\n", movable.entity.name,
                        at.x(), at.y(), movable.places.size() - 1);
  }
  if (!world.tags.empty()) text += "tags:\n";
  for (const RfidTag& tag : world.tags) {
    const Eigen::Vector3d& at = tag.world_from_tag.position;
    const auto material = static_cast<std::size_t>(tag.material);
    text +=
        fmt::format("  - {}: at ({:.2f}, {:.2f}, {:.2f}), looks to {:.0f} deg{}\n", tag.id, at.x(),
                    at.y(), at.z(), degrees(planar(tag.world_from_tag).theta),
                    tag.material == RfidTag::kNothing ? ", hangs free"
                                                      : ", on " + world.materials[material].name);
  }
  if (!world.doors.empty()) text += "doors:\n";
  for (const Door& door : world.doors) {
    text += fmt::format("  - {}: {:g} m wide, hinged at ({:.1f}, {:.1f})\n", door.name, door.width,
                        door.world_from_hinge.x, door.world_from_hinge.y);
  }
  return text;
}

}  // namespace mapbed
