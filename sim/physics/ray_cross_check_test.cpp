// The scene's rays against those of the two physics engines, which are programmed independently.

#include <cmath>
#include <memory>

#include <box2d/box2d.h>
#include <btBulletCollisionCommon.h>
#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/random.h"
#include "sim/scene/scene.h"

namespace mapbed {
namespace {

Entity upright_thing(Geometry geometry, const Pose2& pose) {
  return {.name = "thing",
          .world_from_entity = upright(pose),
          .parts = {{.name = "thing", .geometry = std::move(geometry)}}};
}

// The nearest hit of a Box2D ray, as a fraction of it; 1 where nothing was hit.
class NearestHit : public b2RayCastCallback {
 public:
  float ReportFixture(b2Fixture*, const b2Vec2&, const b2Vec2&, float fraction) override {
    nearest = fraction;
    return fraction;
  }
  float nearest = 1.0F;
};

b2Vec2 in_box2d(const Eigen::Vector2d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y())};
}

TEST(RayCrossCheck, AgreesWithBox2dOnBoxesAndColumns) {
  Rng rng(1);
  World world;
  b2World planar(b2Vec2(0.0F, 0.0F));
  b2Body* ground = planar.CreateBody(std::make_unique<b2BodyDef>().get());
  for (int i = 0; i < 60; ++i) {
    const Pose2 pose{rng.uniform(-10, 10), rng.uniform(-10, 10), rng.uniform(-kPi, kPi)};
    const Eigen::Vector2d size(rng.uniform(0.2, 2.0), rng.uniform(0.2, 2.0));
    if (i % 2 == 0) {
      world.entities.push_back(upright_thing(Box{{size.x(), size.y(), 1.0}}, pose));
      b2PolygonShape shape;
      shape.SetAsBox(static_cast<float>(size.x() / 2), static_cast<float>(size.y() / 2),
                     in_box2d(pose.position()), static_cast<float>(pose.theta));
      ground->CreateFixture(&shape, 0.0F);
    } else {
      world.entities.push_back(upright_thing(Cylinder{size.x() / 2, 1.0}, pose));
      b2CircleShape shape;
      shape.m_p = in_box2d(pose.position());
      shape.m_radius = static_cast<float>(size.x() / 2);
      ground->CreateFixture(&shape, 0.0F);
    }
  }
  const Scene scene(world);

  constexpr double kReach = 30.0;
  int hits = 0, apart = 0;
  for (int i = 0; i < 3000; ++i) {
    const double bearing = rng.uniform(-kPi, kPi);
    const Eigen::Vector2d from(rng.uniform(-12, 12), rng.uniform(-12, 12));
    const Eigen::Vector2d way(std::cos(bearing), std::sin(bearing));
    NearestHit box2d;
    planar.RayCast(&box2d, in_box2d(from), in_box2d(from + kReach * way));
    const Hit hit = scene.cast({{from.x(), from.y(), 0.0}, {way.x(), way.y(), 0.0}});
    // Box2D takes no notice of a shape in which the ray starts.
    if (hit.is_hit() && hit.normal.dot(Eigen::Vector3d(way.x(), way.y(), 0.0)) > 0.0) continue;
    if (!hit.is_hit() && box2d.nearest == 1.0F) continue;
    ++hits;
    // Single precision of coordinates and of fractions of 30 m: some 1e-5 m, more at grazing
    // incidence.
    if (!hit.is_hit() || std::abs(hit.range - kReach * box2d.nearest) > 1e-3) ++apart;
  }
  EXPECT_GT(hits, 1000);
  EXPECT_LE(apart, hits / 500) << "rays that just touch a corner or an edge";
}

// A hilly floor of 2 x 40 x 40 triangles.
TriangleMesh hills(Rng& rng) {
  constexpr std::uint32_t kSide = 41;
  TriangleMesh mesh;
  for (std::uint32_t y = 0; y < kSide; ++y) {
    for (std::uint32_t x = 0; x < kSide; ++x) {
      mesh.vertices.emplace_back(0.5 * x - 10.0, 0.5 * y - 10.0, rng.uniform(-0.4, 0.4));
    }
  }
  for (std::uint32_t y = 0; y + 1 < kSide; ++y) {
    for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
      const std::uint32_t a = y * kSide + x;
      mesh.triangles.push_back({a, a + 1, a + kSide + 1});
      mesh.triangles.push_back({a, a + kSide + 1, a + kSide});
    }
  }
  return mesh;
}

btVector3 in_bullet(const Eigen::Vector3d& p) {
  return {static_cast<btScalar>(p.x()), static_cast<btScalar>(p.y()), static_cast<btScalar>(p.z())};
}

TEST(RayCrossCheck, AgreesWithBulletOnAMesh) {
  Rng rng(2);
  const TriangleMesh mesh = hills(rng);
  btTriangleMesh triangles;
  for (const auto& [a, b, c] : mesh.triangles) {
    triangles.addTriangle(in_bullet(mesh.vertices[a]), in_bullet(mesh.vertices[b]),
                          in_bullet(mesh.vertices[c]));
  }
  btBvhTriangleMeshShape shape(&triangles, true);
  btCollisionObject object;
  object.setCollisionShape(&shape);
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btCollisionWorld bullet(&dispatcher, &broadphase, &configuration);
  bullet.addCollisionObject(&object);

  World world;
  world.entities = {upright_thing(mesh, {})};
  const Scene scene(world);
  constexpr double kReach = 40.0;
  int hits = 0, apart = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d from(rng.uniform(-9, 9), rng.uniform(-9, 9), rng.uniform(0.6, 3.0));
    const Eigen::Vector3d way =
        Eigen::Vector3d(rng.normal(), rng.normal(), -std::abs(rng.normal())).normalized();
    const btVector3 start = in_bullet(from), end = in_bullet(from + kReach * way);
    btCollisionWorld::ClosestRayResultCallback found(start, end);
    bullet.rayTest(start, end, found);
    const Hit hit = scene.cast({from, way});
    if (!hit.is_hit() && !found.hasHit()) continue;
    ++hits;
    const double bullet_range = kReach * static_cast<double>(found.m_closestHitFraction);
    // Single precision of coordinates and of fractions of 40 m, more at grazing incidence.
    if (!hit.is_hit() || std::abs(hit.range - bullet_range) > 1e-3) ++apart;
  }
  EXPECT_GT(hits, 1500);
  EXPECT_LE(apart, hits / 200) << "rays that just touch an edge or a crest";
  bullet.removeCollisionObject(&object);
}

}  // namespace
}  // namespace mapbed
