#pragma once

#include <memory>
#include <span>
#include <vector>

#include "sim/scene/ray.h"
#include "worlds/world.h"

namespace mapbed {

// What a ray can hit: the world, standing still, and things that move. Ranges are exact to 10 um up
// to 100 m from the origin, surfaces being analytic in double precision once Embree has found them.
//
// Queries are const and may run in parallel; moving things may not move meanwhile.
class Scene {
 public:
  // Door leaves of the world move; everything else of it stands still from now on.
  explicit Scene(const World& world);
  ~Scene();
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;

  // Adds a moving thing where its world_from_entity says; gives the id that hits will name, one
  // more than the last one. Material indices are those of the world.
  int add(const Entity& entity);

  // Only for moving things. Costs nothing until the next ray is cast after update().
  void move(int entity, int part, const Pose3& world_from_part);
  void move(int entity, const Pose3& world_from_entity);  // all parts, as they stood when added
  void show(int entity, bool visible);                    // hidden things are not hit
  void update();  // makes the moves above count for the rays

  Hit cast(const Ray& ray) const;
  // Many at once, faster where neighbours run alike (a laser's fan). hits.size() == rays.size().
  void cast(std::span<const Ray> rays, std::span<Hit> hits) const;
  // That nothing stands between two points, by 1 mm at each end.
  bool sees(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
            bool through_glass = false) const;

  std::size_t entity_count() const;
  const Entity& entity(int id) const;  // as it stood when added
  const std::vector<Material>& materials() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mapbed
