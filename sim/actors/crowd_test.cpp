#include "sim/actors/crowd.h"

#include <array>
#include <cmath>

#include "core/testing/throws_input_error.h"
#include "sim/testing/small_world.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;

// A hall of 16 m x 8 m with two columns and a route round it.
World hall() {
  World world = small_room(16.0, 8.0);
  world.name = "hall";
  world.entities.push_back(block("column", {5.0, 4.0}, {0.6, 0.6}));
  world.entities.push_back(block("column", {11.0, 4.0}, {0.6, 0.6}));
  world.crowd.routes = {{.name = "round",
                         .points = {{2.0, 2.0}, {14.0, 2.0}, {14.0, 6.0}, {2.0, 6.0}},
                         .closed = true}};
  world.crowd.places = {{.position = {8.0, 4.0}, .heading = 0.0, .radius = 1.2}};
  return world;
}

const Obstacle kFarRobot{.pose = {-50.0, -50.0, 0.0}, .radius = 0.3};
constexpr int kFirstEntity = 6;

Crowd crowd_of(const World& world, const CrowdOptions& options, const Obstacle& robot = kFarRobot,
               std::uint64_t seed = 1) {
  return Crowd(world, NavigationMap(world, 0.02, 1.9), robot, options, kFirstEntity, Rng(seed));
}

TEST(Crowd, NobodyGetsIntoWallsOrEachOther) {
  const World world = hall();
  const NavigationMap map(world, 0.02, 1.9);
  Crowd crowd = crowd_of(world, {.walkers = 12, .standing = 3});
  ASSERT_EQ(crowd.size(), 15u);
  for (int i = 0; i < 3000; ++i) {
    crowd.step(0.01, {kFarRobot});
    for (std::size_t k = 0; k < crowd.size(); ++k) {
      const Vector2d p = crowd.person(k).body.pose.position();
      ASSERT_GT(p.x(), 0.0);
      ASSERT_LT(p.x(), 16.0);
      ASSERT_GT(p.y(), 0.0);
      ASSERT_LT(p.y(), 8.0);
      ASSERT_GT(map.clearance(p), 0.5 * crowd.person(k).body.radius);
      for (std::size_t other = 0; other < k; ++other) {
        ASSERT_GT((p - crowd.person(other).body.pose.position()).norm(), 0.35);
      }
    }
  }
}

TEST(Crowd, WalkersGetRoundAtAboutTheirSpeed) {
  World world = hall();
  world.crowd.pause_fraction = 0.0;
  world.crowd.group_fraction = 0.0;
  Crowd crowd = crowd_of(world, {.walkers = 4, .mean_speed = 1.0, .speed_sigma = 0.0});
  double way = 0.0;
  std::vector<Vector2d> last;
  for (std::size_t k = 0; k < 4; ++k) last.push_back(crowd.person(k).body.pose.position());
  for (int i = 0; i < 4000; ++i) {
    crowd.step(0.01, {kFarRobot});
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector2d p = crowd.person(k).body.pose.position();
      way += (p - last[k]).norm();
      last[k] = p;
    }
  }
  // Corners and meetings cost some of the 1 m/s that they wish for.
  EXPECT_GT(way / (4 * 40.0), 0.75);
  EXPECT_LT(way / (4 * 40.0), 1.1);
}

TEST(Crowd, WhoStandsStands) {
  Crowd crowd = crowd_of(hall(), {.walkers = 0, .standing = 4});
  std::vector<Vector2d> start;
  for (std::size_t k = 0; k < 4; ++k) start.push_back(crowd.person(k).body.pose.position());
  for (int i = 0; i < 2000; ++i) crowd.step(0.01, {kFarRobot});
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_LT((crowd.person(k).body.pose.position() - start[k]).norm(), 0.6);
    EXPECT_EQ(crowd.person(k).motion, Motion::waiting);
  }
}

TEST(Crowd, ABlockerGetsInFrontOfTheRobotAndLeavesAgain) {
  const Obstacle robot{.pose = {8.0, 2.0, 0.0}, .radius = 0.3};
  Crowd crowd = crowd_of(hall(), {.walkers = 0, .standing = 0, .blockers = 1}, robot);
  bool was_ahead = false;
  bool was_away_after = false;
  for (int i = 0; i < 8000; ++i) {
    crowd.step(0.01, {robot});
    const Vector2d p = crowd.person(0).body.pose.position();
    const double off = (p - Vector2d(9.2, 2.0)).norm();
    was_ahead = was_ahead || off < 0.35;
    was_away_after = was_away_after || (was_ahead && off > 3.0);
  }
  EXPECT_TRUE(was_ahead);
  EXPECT_TRUE(was_away_after);
}

TEST(Crowd, PeopleMakeRoomForTheRobotAndNeverGetIntoIt) {
  Crowd crowd = crowd_of(hall(), {.walkers = 10, .standing = 0});
  const Obstacle robot{.pose = {8.0, 2.0, 0.0}, .radius = 0.35};
  for (int i = 0; i < 3000; ++i) {
    crowd.step(0.01, {robot});
    for (std::size_t k = 0; k < crowd.size(); ++k) {
      const Vector2d p = crowd.person(k).body.pose.position();
      if (i <= 100) continue;  // until those nearby have gone
      ASSERT_GT((p - robot.pose.position()).norm(), 0.35 + 0.15);
    }
  }
}

TEST(Crowd, TheSameSeedGivesTheSamePeople) {
  const auto run = [](std::uint64_t seed) {
    Crowd crowd = crowd_of(hall(), {.walkers = 8, .standing = 2}, kFarRobot, seed);
    for (int i = 0; i < 500; ++i) crowd.step(0.01, {kFarRobot});
    return crowd.person(5).body.pose;
  };
  EXPECT_EQ(run(3), run(3));
  EXPECT_NE(run(3), run(4));
}

TEST(Crowd, AnotherPersonChangesNobodyElsesBody) {
  const Crowd few = crowd_of(hall(), {.walkers = 3, .standing = 0});
  const Crowd more = crowd_of(hall(), {.walkers = 4, .standing = 0});
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(few.person(k).body.pose, more.person(k).body.pose);
    EXPECT_EQ(few.person(k).body.radius, more.person(k).body.radius);
  }
}

// Somebody's trunk stands upright over his body's middle, whose legs are on either side of it.
TEST(Crowd, TellsWhereEveryPartOfEverybodyIs) {
  Crowd crowd = crowd_of(hall(), {.walkers = 2, .standing = 1});
  for (int i = 0; i < 200; ++i) crowd.step(0.01, {kFarRobot});
  const std::vector<Entity> entities = crowd.entities();
  std::vector<MovingPose> poses;
  crowd.append_poses(poses);
  ASSERT_EQ(poses.size(), 3 * entities.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const PersonView person = crowd.person(i / 3);
    EXPECT_EQ(poses[i].entity, kFirstEntity + static_cast<int>(i / 3));
    EXPECT_EQ(poses[i].part, static_cast<int>(i % 3));
    EXPECT_EQ(poses[i].motion, person.motion);
    const Vector2d place = poses[i].world_from_part.position.head<2>();
    const double off = (place - person.body.pose.position()).norm();
    if (poses[i].part == kTrunk) {
      EXPECT_LT(off, 1e-9);
    } else {
      EXPECT_GT(off, 0.1 - 1e-9);  // half the hips' width, and more in mid-stride
      EXPECT_LT(off, 0.5);
    }
  }
  EXPECT_EQ(poses.back().motion, Motion::waiting);  // who stands comes last
}

TEST(Crowd, ManyPeopleAreDividedAsTheWorldDividesItsOwn) {
  const auto divided = [](int people, const CrowdRules& rules) {
    const CrowdOptions o = with_people({}, rules, people);
    return std::array{o.walkers, o.standing, o.blockers};
  };
  const CrowdRules museum{.walkers = 12, .standing = 3};
  EXPECT_EQ(divided(15, museum), (std::array{12, 3, 0}));
  EXPECT_EQ(divided(5, museum), (std::array{4, 1, 0}));
  EXPECT_EQ(divided(1, museum), (std::array{1, 0, 0}));
  EXPECT_EQ(divided(0, museum), (std::array{0, 0, 0}));  // nobody: not those who stand either
  EXPECT_EQ(divided(7, {.walkers = 2, .standing = 2, .blockers = 2}), (std::array{2, 3, 2}));
  EXPECT_EQ(divided(4, {.walkers = 0, .standing = 3}), (std::array{0, 4, 0}));
  EXPECT_EQ(divided(6, {}), (std::array{6, 0, 0}));
}

TEST(Crowd, ThatDoesNotFitIsRefused) {
  EXPECT_INPUT_ERROR(crowd_of(hall(), {.walkers = 5000}), "the crowd does not fit: only ");
  EXPECT_INPUT_ERROR(crowd_of(hall(), {.walkers = 0, .standing = 200}),
                     "people found a free place on the places of world 'hall'; ask for fewer");
}

TEST(Crowd, WithoutRoutesOrPlacesIsRefused) {
  const World room = small_room(4.0, 4.0);
  EXPECT_INPUT_ERROR(crowd_of(room, {.walkers = 1}), "has no routes for people to walk");
  EXPECT_INPUT_ERROR(crowd_of(room, {.standing = 1}), "has no places for people to stand");
}

}  // namespace
}  // namespace mapbed
