#include "worlds/worlds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/input_error.h"
#include "worlds/free_ways.h"

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
    ASSERT_NO_THROW(check_ways(world)) << number;
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
