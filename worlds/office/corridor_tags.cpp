#include "worlds/office/corridor_tags.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/input_error.h"
#include "worlds/tags.h"

namespace mapbed {
namespace {

constexpr double kLowest = 1.0, kHighest = 1.6;  // [m]
constexpr double kMiddle = 0.6;                  // of its piece of the wall, in which a tag is
constexpr double kClosest = 0.1;                 // [m] from one piece to the next

double length_of(const TagStrip& strip) {
  return (strip.to - strip.from).norm();
}

// The place so far along all strips, one after the other. [m]
TagStrip at_distance(const std::vector<TagStrip>& strips, double distance) {
  std::size_t i = 0;
  while (i + 1 < strips.size() && distance > length_of(strips[i])) {
    distance -= length_of(strips[i++]);
  }
  const TagStrip& strip = strips[i];
  const double fraction = std::min(1.0, distance / length_of(strip));
  const Eigen::Vector2d place = strip.from + fraction * (strip.to - strip.from);
  return {place, place, strip.facing};
}

}  // namespace

void add_tags(World& world, const std::vector<TagStrip>& strips, int count, int material, Rng rng) {
  if (count == 0) return;
  double length = 0.0;
  for (const TagStrip& strip : strips) length += length_of(strip);
  const double piece = length / count;
  if (piece < kClosest) {
    throw InputError(
        fmt::format("{} tags do not fit on {:.0f} m of walls; ask for fewer tags", count, length));
  }
  for (int i = 0; i < count; ++i) {
    const double along = (i + 0.5 + kMiddle * rng.uniform(-0.5, 0.5)) * piece;
    const TagStrip place = at_distance(strips, along);
    const Eigen::Vector3d point(place.from.x(), place.from.y(), rng.uniform(kLowest, kHighest));
    world.tags.push_back(
        tag_on_wall(fmt::format("tag_{:03d}", i + 1), point, place.facing, material));
    check_tag(world, world.tags.back());
  }
}

}  // namespace mapbed
