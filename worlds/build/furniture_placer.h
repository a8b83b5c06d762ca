#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "worlds/build/clearance.h"
#include "worlds/geometry/footprint.h"
#include "worlds/world.h"

namespace mapbed {

// Adds furniture where there is room for it.
class FurniturePlacer {
 public:
  explicit FurniturePlacer(World& world);  // paths, crowd and walls stand already

  void keep_clear(const ClearStrip& strip);  // besides those of the world

  // Unless it would come closer than `gap` [m] to something or into a clear strip.
  bool place(Entity entity, double gap = 0.01);

 private:
  struct Taken {
    Footprint footprint;
    Eigen::AlignedBox2d box;
  };
  bool is_free(const Footprint& footprint, double gap) const;
  void take(const Entity& entity, int id);

  World& world_;
  std::vector<ClearStrip> strips_;
  std::vector<Taken> taken_;
};

}  // namespace mapbed
