#pragma once

#include <memory>
#include <span>
#include <vector>

#include "sim/scene/placed_part.h"
#include "sim/scene/ray.h"

namespace mapbed {

// Finds the nearest part on a ray with Embree in robust mode, then the range in double precision:
// from the plane of the triangle or from the analytic shape. Behind Scene; ray_caster.cpp alone
// knows Embree.
class RayCaster {
 public:
  explicit RayCaster(const std::vector<PlacedPart>& still);
  ~RayCaster();

  // Moving parts, numbered from 0 as they are added. They count for rays after update().
  int add(const PlacedPart& moving);
  void place(int moving, const Pose3& world_from_part, bool visible);
  void update();

  Hit cast(const Ray& ray) const;
  void cast(std::span<const Ray> rays, std::span<Hit> hits) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mapbed
