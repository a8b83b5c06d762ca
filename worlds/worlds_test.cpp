#include "worlds/worlds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/input_error.h"
#include "worlds/build/clearance.h"
#include "worlds/geometry/footprint.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

Settings seed(int number) {
  return {parse_setting("seed=" + std::to_string(number))};
}

class EveryWorld : public ::testing::TestWithParam<std::string> {};

// Every builder checks its ways itself; here they must also be worth it.
TEST_P(EveryWorld, HasFreePathsForFiftySeeds) {
  for (int number = 0; number < 50; ++number) {
    const World world = build_world(GetParam(), seed(number));
    ASSERT_NO_THROW(check_clearance(world)) << number;
    ASSERT_FALSE(world.paths.empty());
    for (const NamedPath& path : world.paths) EXPECT_GE(path.clearance, 0.3) << path.name;
  }
}

TEST_P(EveryWorld, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const Eigen::AlignedBox3d one = bounds_of(build_world(GetParam(), seed(1)));
  EXPECT_TRUE(one.isApprox(bounds_of(build_world(GetParam(), seed(1)))));
  EXPECT_FALSE(one.isApprox(bounds_of(build_world(GetParam(), seed(2))), 1e-3));
}

TEST_P(EveryWorld, NamesItsDoorsLeaves) {
  const World world = build_world(GetParam());
  for (const Door& door : world.doors) {
    const Entity& leaf = world.entities[static_cast<std::size_t>(door.entity)];
    EXPECT_EQ(leaf.kind, EntityKind::door);
    EXPECT_EQ(leaf.name, door.name);
  }
}

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const WorldKind& kind : world_kinds()) names.push_back(kind.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Worlds, EveryWorld, ::testing::ValuesIn(all_names()),
                         [](const auto& name) { return name.param; });

std::string message_of(const std::string& name, const Settings& settings = {}) {
  try {
    build_world(name, settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

// What a laser sees through the wall of glass is the room behind it, not the back of a cabinet.
TEST(Worlds, KeepTheGlassOfTheOfficeFree) {
  for (int number = 0; number < 10; ++number) {
    const World world = build_world("office", seed(number));
    std::vector<Footprint> glass, furniture;
    for (const Footprint& footprint : footprints(world, 0.3, 0.4)) {
      const Entity& entity = world.entities[static_cast<std::size_t>(footprint.entity)];
      const auto material = static_cast<std::size_t>(footprint.material);
      if (world.materials[material].transmittance > 0.0) glass.push_back(footprint);
      if (entity.kind == EntityKind::furniture) furniture.push_back(footprint);
    }
    ASSERT_GE(glass.size(), 3u);
    for (const Footprint& pane : glass) {
      for (const Footprint& piece : furniture) EXPECT_GT(distance_between(pane, piece), 0.5);
    }
  }
}

double length_of(const NamedPath& path) {
  double sum = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    sum += (path.points[i].position - path.points[i - 1].position).norm();
  }
  return sum;
}

// A drive cuts corners: 0.1 to 0.2 m each with the driver's look-ahead of 0.6 m.
TEST(Worlds, HavePathsAsLongAsTheThesisSays) {
  const NamedPath tour = path_by_name(build_world("museum"), "tour_with_one_loop");
  EXPECT_NEAR(length_of(tour), 57.0 + 4 * 0.15, 0.25);  // chapters 3 and 4
  const NamedPath rounds = path_by_name(build_world("hall_loop"), "rounds");
  EXPECT_NEAR(length_of(rounds), 251.0 + 13 * 0.15, 1.0);  // Figure 5.10
  const NamedPath corridor = path_by_name(build_world("office_corridor"), "there_and_back");
  EXPECT_NEAR(length_of(corridor), 74.0, 0.2);  // Figure 4.5
}

TEST(Worlds, ThePathRoundsGoesOnByAFractionOfARound) {
  const auto rounds = [](const std::string& fraction) {
    const Settings settings{parse_setting("rounds=2"), parse_setting("last_round=" + fraction)};
    return length_of(path_by_name(build_world("loop_corridor", settings), "rounds"));
  };
  EXPECT_NEAR(rounds("0.3"), 2.3 / 2.0 * rounds("0"), 1e-9);
  EXPECT_NEAR(rounds("1"), 3.0 / 2.0 * rounds("0"), 1e-9);
}

TEST(Worlds, OfOneBuilderHaveNamesOfTheirOwn) {
  EXPECT_EQ(build_world("hall_loop").name, "hall_loop");
  EXPECT_EQ(build_world("nested_loops").name, "nested_loops");
}

TEST(Worlds, FilesInTheirFolderAreFoundByName) {
  EXPECT_THAT(world_file_names(), ::testing::Contains("workshop"));
  EXPECT_EQ(build_world("workshop").name, "workshop");
  EXPECT_THAT(message_of("wokshop"), HasSubstr("did you mean 'workshop'?"));
}

TEST(Worlds, SuggestTheNameThatWasMeant) {
  EXPECT_THAT(message_of("offcie"), HasSubstr("unknown world 'offcie'; did you mean 'office'?"));
}

TEST(Worlds, SuggestTheOptionThatWasMeant) {
  EXPECT_THAT(message_of("office", {parse_setting("corridor_with=2 m")}),
              HasSubstr("corridor_width"));
}

TEST(Worlds, RefuseRoomsThatDoNotFit) {
  EXPECT_THAT(message_of("office", {parse_setting("rooms_a_side=20")}),
              HasSubstr("do not fit; a larger size"));
}

}  // namespace
}  // namespace mapbed
