#include "sim/actors/social_force.h"

#include <cmath>

#include "core/geometry/angle.h"
#include "sim/testing/small_world.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;

constexpr double kStep = 0.005;  // [s]

Walker walker_at(const Vector2d& position, const Vector2d& wish) {
  Walker walker;
  walker.position = position;
  walker.wish = wish;
  walker.heading = wish.norm() > 0.0 ? std::atan2(wish.y(), wish.x()) : 0.0;
  return walker;
}

void walk(std::vector<Walker>& walkers, const NavigationMap& plan, double seconds,
          std::span<const RoundObstacle> robots = {}) {
  for (int i = 0; i < static_cast<int>(seconds / kStep); ++i) {
    advance(walkers, plan, {}, robots, {}, kStep);
  }
}

TEST(SocialForce, AloneReachesTheWishedVelocityWithItsTimeConstant) {
  const NavigationMap plan(World{}, 0.02, 1.9);
  std::vector<Walker> walkers{walker_at({0.0, 0.0}, {1.2, 0.0})};
  walk(walkers, plan, 0.5);
  EXPECT_NEAR(walkers[0].velocity.x(), 1.2 * (1.0 - std::exp(-1.0)), 0.01);
  walk(walkers, plan, 5.0);
  EXPECT_NEAR(walkers[0].velocity.x(), 1.2, 1e-3);
}

TEST(SocialForce, TurnsIntoTheWishedDirection) {
  const NavigationMap plan(World{}, 0.02, 1.9);
  std::vector<Walker> walkers{walker_at({0.0, 0.0}, {1.0, 0.0})};
  walk(walkers, plan, 3.0);
  walkers[0].wish = {0.0, 1.0};
  walk(walkers, plan, 4.0);
  EXPECT_NEAR(walkers[0].heading, kPi / 2.0, 0.05);
  EXPECT_NEAR(walkers[0].velocity.y(), 1.0, 0.02);
}

TEST(SocialForce, TwoWhoMeetPassEachOtherWithoutOverlap) {
  const NavigationMap plan(small_room(12.0, 4.0), 0.02, 1.9);
  std::vector<Walker> walkers{walker_at({1.0, 2.0}, {1.2, 0.0}),
                              walker_at({11.0, 2.2}, {-1.2, 0.0})};
  double nearest = 10.0;
  for (int i = 0; i < 2400; ++i) {
    advance(walkers, plan, {}, {}, {}, kStep);
    nearest = std::min(nearest, (walkers[0].position - walkers[1].position).norm());
    if (walkers[0].position.x() > walkers[1].position.x() + 1.0) break;
  }
  EXPECT_GT(walkers[0].position.x(), walkers[1].position.x());
  EXPECT_GT(nearest, 0.5);  // of 0.6 m, the sum of the radii: bodies give a little
}

TEST(SocialForce, NobodyWalksThroughAWall) {
  const NavigationMap plan(small_room(6.0, 4.0), 0.02, 1.9);
  for (const double speed : {0.8, 1.5, 2.5}) {
    std::vector<Walker> walkers;
    for (int i = 0; i < 8; ++i) {  // a push of eight against one wall
      walkers.push_back(walker_at({3.0 - 0.3 * (i % 4), 1.0 + 0.7 * (i / 4)}, {speed, 0.0}));
    }
    for (int i = 0; i < 2000; ++i) {
      advance(walkers, plan, {}, {}, {}, kStep);
      for (const Walker& w : walkers) {
        ASSERT_LT(w.position.x(), 6.0 - 0.5 * w.radius);
        ASSERT_GT(w.position.x(), 0.0);
        ASSERT_GT(w.position.y(), 0.0);
        ASSERT_LT(w.position.y(), 4.0);
      }
    }
  }
}

TEST(SocialForce, NobodyWalksThroughTheRobot) {
  const NavigationMap plan(small_room(10.0, 4.0), 0.02, 1.9);
  const RoundObstacle robot{{5.0, 2.0}, {0.0, 0.0}, 0.35};
  std::vector<Walker> walkers{walker_at({2.0, 2.0}, {1.5, 0.0}),
                              walker_at({8.0, 2.05}, {-1.5, 0.0})};
  for (int i = 0; i < 3000; ++i) {
    advance(walkers, plan, {}, {&robot, 1}, {}, kStep);
    for (const Walker& w : walkers) {
      ASSERT_GT((w.position - robot.position).norm(), robot.radius + 0.6 * w.radius);
    }
  }
}

TEST(SocialForce, ADoorOf90CentimetresIsPassed) {
  World world = small_room(8.0, 4.0);
  world.entities.push_back(block("south post", {4.0, 0.775}, {0.2, 1.55}));
  world.entities.push_back(block("north post", {4.0, 3.225}, {0.2, 1.55}));
  const NavigationMap plan(world, 0.02, 1.9);
  for (const double radius : {0.25, 0.30, 0.35}) {
    std::vector<Walker> walkers{walker_at({1.5, 1.7}, {1.1, 0.0})};
    walkers[0].radius = radius;
    for (int i = 0; i < 3000 && walkers[0].position.x() < 6.0; ++i) {
      const Vector2d goal = walkers[0].position.x() < 3.7 ? Vector2d(4.2, 2.0) : Vector2d(7.0, 2.0);
      walkers[0].wish = 1.1 * (goal - walkers[0].position).normalized();
      advance(walkers, plan, {}, {}, {}, kStep);
    }
    EXPECT_GT(walkers[0].position.x(), 6.0) << radius;
  }
}

TEST(SocialForce, WhoStandsStaysAndLooksWhereHeWants) {
  const NavigationMap plan(World{}, 0.02, 1.9);
  std::vector<Walker> walkers{walker_at({0.0, 0.0}, {0.0, 0.0})};
  walkers[0].keeps_heading = true;
  walkers[0].wished_heading = 2.0;
  walk(walkers, plan, 8.0);
  EXPECT_NEAR(walkers[0].heading, 2.0, 0.02);
  EXPECT_NEAR(walkers[0].position.norm(), 0.0, 1e-6);
}

// Two who touch by 10 cm while they pass each other at 1 m/s, without what pushes them apart:
// k2 o dv / m changes their speeds, nothing else does.
TEST(SocialForce, BodiesThatRubSlowEachOtherDown) {
  const NavigationMap plan(World{}, 0.02, 1.9);
  std::vector<Walker> walkers{walker_at({0.0, 0.0}, {0.0, 0.5}),
                              walker_at({0.5, 0.0}, {0.0, -0.5})};
  for (Walker& walker : walkers) walker.velocity = walker.wish;
  SocialForceOptions options;
  options.repulsion = options.stiffness = 0.0;
  options.friction = 2.4e3;
  advance(walkers, plan, {}, {}, options, kStep);
  const double slower = options.friction * 0.1 * 1.0 / walkers[0].mass * kStep;
  EXPECT_NEAR(walkers[0].velocity.y(), 0.5 - slower, 1e-9);
  EXPECT_NEAR(walkers[1].velocity.y(), -0.5 + slower, 1e-9);
  EXPECT_NEAR(walkers[0].velocity.x(), 0.0, 1e-9);
}

}  // namespace
}  // namespace mapbed
