#include "worlds/tags.h"

#include <cmath>

#include <fmt/format.h>

#include "core/file/tokens.h"
#include "core/input_error.h"
#include "worlds/geometry/footprint.h"

namespace mapbed {
namespace {

constexpr double kBeforeWall = 0.01;  // [m]
constexpr double kBehind = 0.1;       // [m] what is farther behind a tag does not hold it
constexpr double kProbe = 0.01;       // [m] steps of the way behind it
constexpr double kThin = 1e-4;        // [m] height of the slice that is looked at

// What a point lies in; null: in nothing.
const Footprint* solid_at(const std::vector<Footprint>& slice, const Eigen::Vector3d& point) {
  for (const Footprint& footprint : slice) {
    if (covers(footprint, point.head<2>())) return &footprint;
  }
  return nullptr;
}

std::vector<Footprint> slice_at(const World& world, double z) {
  return footprints(world, z - kThin, z + kThin);
}

}  // namespace

RfidTag tag_on_wall(const std::string& id, const Eigen::Vector3d& point, double facing,
                    int material) {
  const Eigen::Vector3d out(std::cos(facing), std::sin(facing), 0.0);
  return {id, {point + kBeforeWall * out, rotation_of(facing, 0.0, 0.0)}, material};
}

int material_behind(const World& world, const Pose3& world_from_tag) {
  for (double depth = kProbe; depth <= kBehind; depth += kProbe) {
    const Eigen::Vector3d point = world_from_tag * Eigen::Vector3d(-depth, 0.0, 0.0);
    const std::vector<Footprint> slice = slice_at(world, point.z());
    if (const Footprint* solid = solid_at(slice, point)) return solid->material;
  }
  return RfidTag::kNothing;
}

void check_tag(const World& world, const RfidTag& tag) {
  if (words_in(tag.id) != 1 || tag.id.find_first_of(" \t") != std::string::npos) {
    throw InputError(
        fmt::format("the tag's id {} is not one word; take letters, digits and "
                    "underscores, as in tag_017",
                    in_quotes(tag.id)));
  }
  for (const RfidTag& other : world.tags) {
    if (&other == &tag || other.id != tag.id) continue;
    throw InputError(fmt::format("a second tag is called {}; give each tag an id of its own",
                                 in_quotes(tag.id)));
  }
  const Eigen::Vector3d& at = tag.world_from_tag.position;
  const std::vector<Footprint> slice = slice_at(world, at.z());
  if (const Footprint* solid = solid_at(slice, at)) {
    throw InputError(fmt::format(
        "tag {} lies inside {} at ({:.2f} m, {:.2f} m, {:.2f} m); put it a centimetre before the "
        "surface",
        in_quotes(tag.id), in_quotes(world.entities[static_cast<std::size_t>(solid->entity)].name),
        at.x(), at.y(), at.z()));
  }
}

}  // namespace mapbed
