#include "worlds/build/furniture_placer.h"

namespace mapbed {
namespace {

constexpr double kLow = 0.02;  // [m] what is lower can be driven over
constexpr double kHigh = 1.8;  // [m] what is higher does not matter to anybody

}  // namespace

FurniturePlacer::FurniturePlacer(World& world) : world_(world), strips_(clear_strips(world)) {
  for (std::size_t id = 0; id < world.entities.size(); ++id) {
    take(world.entities[id], static_cast<int>(id));
  }
}

void FurniturePlacer::keep_clear(const ClearStrip& strip) {
  strips_.push_back(strip);
}

bool FurniturePlacer::place(Entity entity, double gap) {
  for (const Footprint& footprint : footprints(entity, 0, kLow, world_.ceiling)) {
    if (!is_free(footprint, gap)) return false;
  }
  take(entity, static_cast<int>(world_.entities.size()));
  world_.entities.push_back(std::move(entity));
  return true;
}

bool FurniturePlacer::is_free(const Footprint& footprint, double gap) const {
  const Eigen::AlignedBox2d box = bounds_of(footprint);
  for (const ClearStrip& strip : strips_) {
    if (box.exteriorDistance(bounds_of(strip)) >= strip.clearance + gap) continue;
    if (distance_to(footprint, strip.from, strip.to) < strip.clearance + gap) return false;
  }
  for (const Taken& taken : taken_) {
    if (box.exteriorDistance(taken.box) >= gap) continue;
    if (distance_between(footprint, taken.footprint) < gap) return false;
  }
  return true;
}

void FurniturePlacer::take(const Entity& entity, int id) {
  for (const Footprint& footprint : footprints(entity, id, kLow, kHigh)) {
    taken_.push_back({footprint, bounds_of(footprint)});
  }
}

}  // namespace mapbed
