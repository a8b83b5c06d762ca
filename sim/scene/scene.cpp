#include "sim/scene/scene.h"

#include "core/check.h"
#include "sim/scene/ray_caster.h"

namespace mapbed {
namespace {

constexpr int kStill = -1;
constexpr double kEndGap = 0.001;  // [m] left out at both ends of a line of sight

PlacedPart placed(const Entity& entity, int id, std::size_t part,
                  const std::vector<Material>& materials) {
  const Part& p = entity.parts[part];
  CHECK(p.material >= 0 && static_cast<std::size_t>(p.material) < materials.size());
  return {.geometry = p.geometry,
          .world_from_part = entity.world_from_entity * p.entity_from_part,
          .entity = id,
          .part = static_cast<int>(part),
          .material = p.material,
          .glass = materials[static_cast<std::size_t>(p.material)].transmittance > 0.0};
}

std::vector<PlacedPart> still_parts(const World& world) {
  std::vector<PlacedPart> parts;
  for (std::size_t id = 0; id < world.entities.size(); ++id) {
    const Entity& entity = world.entities[id];
    if (entity.kind == EntityKind::door) continue;
    for (std::size_t part = 0; part < entity.parts.size(); ++part) {
      parts.push_back(placed(entity, static_cast<int>(id), part, world.materials));
    }
  }
  return parts;
}

}  // namespace

struct Scene::State {
  std::vector<Material> materials;
  std::vector<Entity> entities;
  std::vector<int> first_moving_part;          // of each entity, as the ray caster counts; kStill
  std::vector<std::vector<Pose3>> part_poses;  // world_from_part of each entity that moves
  std::vector<bool> visible;
  RayCaster caster;

  explicit State(const World& world) : materials(world.materials), caster(still_parts(world)) {}

  void add(const Entity& entity, bool moves) {
    const int id = static_cast<int>(entities.size());
    entities.push_back(entity);
    visible.push_back(true);
    int first = kStill;
    std::vector<Pose3> poses;
    for (std::size_t part = 0; moves && part < entity.parts.size(); ++part) {
      const PlacedPart part_there = placed(entity, id, part, materials);
      const int slot = caster.add(part_there);
      if (part == 0) first = slot;
      poses.push_back(part_there.world_from_part);
    }
    first_moving_part.push_back(first);
    part_poses.push_back(std::move(poses));
  }

  std::size_t moving(int id) const {
    const auto e = static_cast<std::size_t>(id);
    CHECK(id >= 0 && e < entities.size() && first_moving_part[e] != kStill);
    return e;
  }

  void place(std::size_t e, std::size_t part) {
    caster.place(first_moving_part[e] + static_cast<int>(part), part_poses[e][part], visible[e]);
  }
};

Scene::Scene(const World& world) : state_(std::make_unique<State>(world)) {
  for (const Entity& entity : world.entities) {
    state_->add(entity, entity.kind == EntityKind::door);
  }
  update();
}

Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

int Scene::add(const Entity& entity) {
  state_->add(entity, true);
  return static_cast<int>(state_->entities.size()) - 1;
}

void Scene::move(int entity, int part, const Pose3& world_from_part) {
  const std::size_t e = state_->moving(entity);
  const auto p = static_cast<std::size_t>(part);
  CHECK(part >= 0 && p < state_->part_poses[e].size());
  state_->part_poses[e][p] = world_from_part;
  state_->place(e, p);
}

void Scene::move(int entity, const Pose3& world_from_entity) {
  const std::vector<Part>& parts = this->entity(entity).parts;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    move(entity, static_cast<int>(part), world_from_entity * parts[part].entity_from_part);
  }
}

void Scene::show(int entity, bool visible) {
  const std::size_t e = state_->moving(entity);
  state_->visible[e] = visible;
  for (std::size_t part = 0; part < state_->part_poses[e].size(); ++part) state_->place(e, part);
}

void Scene::update() {
  state_->caster.update();
}

Hit Scene::cast(const Ray& ray) const {
  return state_->caster.cast(ray);
}

void Scene::cast(std::span<const Ray> rays, std::span<Hit> hits) const {
  state_->caster.cast(rays, hits);
}

bool Scene::sees(const Eigen::Vector3d& from, const Eigen::Vector3d& to, bool through_glass) const {
  const Eigen::Vector3d way = to - from;
  const double length = way.norm();
  if (length <= 2 * kEndGap) return true;
  return !cast({from, way / length, kEndGap, length - kEndGap, through_glass}).is_hit();
}

std::size_t Scene::entity_count() const {
  return state_->entities.size();
}

const Entity& Scene::entity(int id) const {
  CHECK(id >= 0 && static_cast<std::size_t>(id) < state_->entities.size());
  return state_->entities[static_cast<std::size_t>(id)];
}

const std::vector<Material>& Scene::materials() const {
  return state_->materials;
}

}  // namespace mapbed
