#include "sim/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/random.h"
#include "sim/scene/analytic.h"

namespace mapbed {
namespace {

constexpr double kExact = 1e-5;  // [m] what a range may be off

Eigen::Vector3d any_direction(Rng& rng) {
  return Eigen::Vector3d(rng.normal(), rng.normal(), rng.normal()).normalized();
}

Pose3 any_pose(Rng& rng, double reach) {
  return {{rng.uniform(-reach, reach), rng.uniform(-reach, reach), rng.uniform(-reach, reach)},
          rotation_of(rng.uniform(-kPi, kPi), rng.uniform(-1.5, 1.5), rng.uniform(-kPi, kPi))};
}

Entity thing(const std::string& name, Geometry geometry, const Pose3& pose = {}) {
  return {.name = name,
          .kind = EntityKind::furniture,
          .world_from_entity = pose,
          .parts = {{.name = name, .geometry = std::move(geometry)}}};
}

World world_of(std::vector<Entity> entities) {
  World world;
  world.entities = std::move(entities);
  return world;
}

int material_of(const World& world, const std::string& name) {
  for (std::size_t i = 0; i < world.materials.size(); ++i) {
    if (world.materials[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

Entity glass_pane(const World& world, double x) {
  Entity pane = thing("pane", Box{{0.01, 4.0, 4.0}}, upright({x, 0, 0}));
  pane.parts[0].material = material_of(world, "glass");
  return pane;
}

// A ray from `origin` towards a point within `reach` of the centre of the scene.
Ray aimed(Rng& rng, const Eigen::Vector3d& origin, double reach) {
  const Eigen::Vector3d target = reach * any_direction(rng) * rng.uniform();
  return {origin, (target - origin).normalized()};
}

// Whether the ray passes an edge of the box so closely that rounding decides what it hits.
bool grazes_an_edge(const Box& box, const Ray& ray) {
  constexpr double kNear = 5e-5;  // [m] several times the rounding of coordinates of 80 m
  const auto grown = [&](double by) {
    return first_crossing(Box{box.size + Eigen::Vector3d::Constant(2 * by)}, ray);
  };
  const auto large = grown(kNear);
  const auto small = grown(-kNear);
  if (large.has_value() != small.has_value()) return true;
  return large && large->normal != small->normal;
}

TEST(Scene, IsExactOnBoxesMadeOfTriangles) {
  Rng rng(1);
  int hits = 0;
  for (int box_number = 0; box_number < 20; ++box_number) {
    const Box box{{rng.uniform(0.1, 3), rng.uniform(0.1, 3), rng.uniform(0.1, 3)}};
    const Pose3 world_from_box = any_pose(rng, 1.0);
    const Scene scene(world_of({thing("box", mesh_of(box), world_from_box)}));
    for (int i = 0; i < 200; ++i) {
      const Ray ray = aimed(rng, 80.0 * any_direction(rng), 2.0);
      Ray in_box = ray;
      in_box.origin = inverse(world_from_box) * ray.origin;
      in_box.direction = world_from_box.rotation.conjugate() * ray.direction;
      if (grazes_an_edge(box, in_box)) continue;
      const auto expected = first_crossing(box, in_box);
      const Hit hit = scene.cast(ray);
      ASSERT_EQ(hit.is_hit(), expected.has_value());
      if (!expected) continue;
      ++hits;
      EXPECT_NEAR(hit.range, expected->range, kExact);
      EXPECT_LT((hit.normal - world_from_box.rotation * expected->normal).norm(), 1e-9);
    }
  }
  EXPECT_GT(hits, 500);
}

// The point hit lies on the cylinder, and before it the ray is outside.
TEST(Scene, IsExactOnCylinders) {
  Rng rng(2);
  int hits = 0;
  for (int number = 0; number < 20; ++number) {
    const Cylinder cylinder{rng.uniform(0.03, 1.0), rng.uniform(0.5, 3.0)};
    const Pose3 pose = any_pose(rng, 1.0);
    const Scene scene(world_of({thing("column", cylinder, pose)}));
    for (int i = 0; i < 200; ++i) {
      const Ray ray = aimed(rng, 80.0 * any_direction(rng), 2.0);
      const Hit hit = scene.cast(ray);
      if (!hit.is_hit()) continue;
      ++hits;
      const Eigen::Vector3d p = inverse(pose) * (ray.origin + hit.range * ray.direction);
      const double outside_side = p.head<2>().norm() - cylinder.radius;
      const double outside_end = std::abs(p.z()) - cylinder.height / 2;
      EXPECT_NEAR(std::max(outside_side, outside_end), 0.0, kExact);
      EXPECT_LT(hit.normal.dot(ray.direction), 0.0);
    }
  }
  EXPECT_GT(hits, 500);
}

TEST(Scene, SeesAThinLegFromFarAway) {
  const Scene scene(world_of({thing("leg", Cylinder{0.02, 1.0}, upright({80.0, 0.0, 0.0}))}));
  for (const double off : {-0.0199, 0.0, 0.01, 0.0199}) {
    const Hit hit = scene.cast({{0.0, off, 0.0}, {1.0, 0.0, 0.0}});
    EXPECT_NEAR(hit.range, 80.0 - std::sqrt(0.02 * 0.02 - off * off), kExact) << off;
  }
  EXPECT_FALSE(scene.cast({{0.0, 0.0201, 0.0}, {1.0, 0.0, 0.0}}).is_hit());
}

TEST(Scene, IsExactOnAWallAtGrazingIncidence) {
  const Extrusion wall{{{-100, 2.0}, {100, 2.0}, {100, 2.2}, {-100, 2.2}}, 0.0, 3.0};
  const Scene scene(world_of({thing("wall", wall)}));
  for (const double bearing : {90.0, 45.0, 10.0, 3.0, 1.5}) {
    const double angle = radians(bearing);
    const Hit hit = scene.cast({{0.0, 0.0, 1.0}, {std::cos(angle), std::sin(angle), 0.0}});
    EXPECT_NEAR(hit.range, 2.0 / std::sin(angle), kExact) << bearing;
  }
}

TEST(Scene, NamesTheNearestThingWithPartAndMaterial) {
  World world = world_of({thing("far", Box{}, upright({5, 0, 0}))});
  Entity table = thing("leg", Cylinder{0.05, 2.0}, upright({3, 0, 0}));
  table.parts.push_back({.name = "top", .geometry = Box{{1, 1, 0.1}}, .material = 3});
  table.parts[1].entity_from_part = upright({0, 0, 0}, 1.0);
  world.entities.push_back(table);
  const Scene scene(world);

  const Hit leg = scene.cast({{0, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(leg.entity, 1);
  EXPECT_EQ(leg.part, 0);
  const Hit top = scene.cast({{0, 0, 1}, {1, 0, 0}});
  EXPECT_EQ(top.entity, 1);
  EXPECT_EQ(top.part, 1);
  EXPECT_EQ(top.material, 3);
  EXPECT_EQ(scene.cast({{0, 2, 0}, {1, 0, 0}}).entity, -1);
}

TEST(Scene, FollowsWhatMoves) {
  Scene scene(world_of({thing("wall", Box{{0.1, 10, 10}}, upright({9, 0, 0}))}));
  const int box = scene.add(thing("box", Box{{1, 1, 1}}, upright({3, 0, 0})));
  const int mesh = scene.add(thing("mesh", mesh_of(Box{{1, 1, 1}}), upright({6, 0, 0})));
  const Ray ahead{{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(scene.cast(ahead).entity, 0) << "what was added counts after update() only";
  scene.update();
  EXPECT_EQ(scene.cast(ahead).entity, box);

  scene.move(box, upright({3, 5, 0}));
  scene.update();
  EXPECT_EQ(scene.cast(ahead).entity, mesh);
  EXPECT_NEAR(scene.cast(ahead).range, 5.5, kExact);

  scene.move(mesh, upright({7, 0.2, radians(90)}));
  scene.update();
  EXPECT_NEAR(scene.cast(ahead).range, 6.5, kExact);
  EXPECT_LT((scene.cast(ahead).normal - Eigen::Vector3d(-1, 0, 0)).norm(), 1e-9);

  scene.show(mesh, false);
  scene.update();
  EXPECT_EQ(scene.cast(ahead).entity, 0);
  scene.move(box, upright({4, 0, 0}));
  scene.show(box, false);
  scene.update();
  EXPECT_EQ(scene.cast(ahead).entity, 0);
  scene.show(box, true);
  scene.show(mesh, true);
  scene.update();
  EXPECT_NEAR(scene.cast(ahead).range, 3.5, kExact);
}

TEST(Scene, IsExactOnAMovedMesh) {
  Rng rng(3);
  Scene scene(world_of({}));
  const Box box{{0.8, 1.6, 1.1}};
  const int id = scene.add(thing("box", mesh_of(box)));
  for (int i = 0; i < 200; ++i) {
    const Pose3 pose = any_pose(rng, 30.0);
    scene.move(id, pose);
    scene.update();
    const Eigen::Vector3d origin = pose.position + 40.0 * any_direction(rng);
    const Eigen::Vector3d target = pose.position + 0.5 * any_direction(rng);
    const Ray ray{origin, (target - origin).normalized()};
    Ray in_box = ray;
    in_box.origin = inverse(pose) * ray.origin;
    in_box.direction = pose.rotation.conjugate() * ray.direction;
    if (grazes_an_edge(box, in_box)) continue;
    const auto expected = first_crossing(box, in_box);
    const Hit hit = scene.cast(ray);
    ASSERT_EQ(hit.is_hit(), expected.has_value());
    if (expected) {
      EXPECT_NEAR(hit.range, expected->range, kExact);
    }
  }
}

TEST(Scene, MovesAPartOnItsOwn) {
  Scene scene(world_of({}));
  Entity person = thing("left leg", Cylinder{0.07, 0.8}, upright({2, 0, 0}));
  person.parts.push_back({.name = "right leg", .geometry = Cylinder{0.07, 0.8}});
  person.parts[1].entity_from_part = upright({0.0, -0.3, 0});
  const int id = scene.add(person);
  scene.move(id, 1, upright({1.5, 0, 0}));
  scene.update();
  const Hit hit = scene.cast({{0, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(hit.part, 1);
  EXPECT_NEAR(hit.range, 1.43, kExact);
}

TEST(Scene, LetsRaysThroughGlassThatAskForIt) {
  World world = world_of({thing("wall", Box{{1, 4, 4}}, upright({5.5, 0, 0}))});
  world.entities.push_back(glass_pane(world, 2.0));
  Scene scene(world);
  const int moving_pane = scene.add(glass_pane(world, 1.0));
  scene.update();
  Ray ray{{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(scene.cast(ray).entity, moving_pane);
  ray.through_glass = true;
  EXPECT_EQ(scene.cast(ray).entity, 0);
  EXPECT_NEAR(scene.cast(ray).range, 5.0, kExact);
  EXPECT_TRUE(scene.sees({0, 0, 0}, {4, 0, 0}, true));
  EXPECT_FALSE(scene.sees({0, 0, 0}, {4, 0, 0}));
  EXPECT_FALSE(scene.sees({0, 0, 0}, {7, 0, 0}, true));
}

TEST(Scene, KeepsToTheRangesOfTheRay) {
  const Scene scene(world_of(
      {thing("near", Box{}, upright({2, 0, 0})), thing("leg", Cylinder{}, upright({5, 0, 0}))}));
  Ray ray{{0, 0, 0}, {1, 0, 0}};
  ray.max_range = 1.4;
  EXPECT_FALSE(scene.cast(ray).is_hit());
  ray.max_range = 1.6;
  EXPECT_NEAR(scene.cast(ray).range, 1.5, kExact);
  ray.max_range = 100.0;
  ray.min_range = 1.6;
  EXPECT_NEAR(scene.cast(ray).range, 2.5, kExact) << "from inside: the far face";
  ray.min_range = 2.6;
  EXPECT_NEAR(scene.cast(ray).range, 4.5, kExact);
}

TEST(Scene, FindsTheSameForManyRaysAsForOne) {
  Rng rng(4);
  World world;
  for (int i = 0; i < 40; ++i) {
    world.entities.push_back(thing("box", mesh_of(Box{{1, 0.5, 2}}), any_pose(rng, 8.0)));
    world.entities.push_back(thing("leg", Cylinder{0.1, 3.0}, any_pose(rng, 8.0)));
  }
  Scene scene(world);
  for (int i = 0; i < 10; ++i) scene.add(thing("mover", Cylinder{0.2, 1.0}, any_pose(rng, 5.0)));
  scene.update();

  std::vector<Ray> rays;
  for (int i = 0; i < 1003; ++i) rays.push_back({{0.1, 0.2, 0.3}, any_direction(rng)});
  std::vector<Hit> hits(rays.size());
  scene.cast(rays, hits);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Hit one = scene.cast(rays[i]);
    EXPECT_EQ(one.entity, hits[i].entity);
    EXPECT_EQ(one.range, hits[i].range);
  }
}

TEST(Scene, MovesTheDoorsOfItsWorld) {
  Entity leaf = thing("leaf", Box{{0.9, 0.04, 2.0}}, upright({2, 0, 0}));
  leaf.kind = EntityKind::door;
  leaf.parts[0].entity_from_part = upright({0.45, 0, 0});
  Scene scene(world_of({leaf}));
  const Ray across{{2.5, -2, 0}, {0, 1, 0}};
  EXPECT_NEAR(scene.cast(across).range, 1.98, kExact);
  scene.move(0, upright({2, 0, radians(90)}));
  scene.update();
  EXPECT_FALSE(scene.cast(across).is_hit());
}

}  // namespace
}  // namespace mapbed
