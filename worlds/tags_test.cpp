#include "worlds/tags.h"

#include <gmock/gmock.h>

#include "core/testing/throws_input_error.h"
#include "worlds/office/office.h"

namespace mapbed {
namespace {

// A block of metal from x 1 to 2, 1 m high.
World world_with_block() {
  World world;
  Entity block{.name = "safe", .world_from_entity = upright({1.5, 0.0, 0.0}, 0.5)};
  block.parts = {{"block", Box{{1.0, 1.0, 1.0}}, {}, material_index(world, "metal")}};
  world.entities = {block};
  return world;
}

RfidTag tag_at(const std::string& id, double x, double y, double z, double facing = 0.0) {
  return {id, {{x, y, z}, rotation_of(facing, 0.0, 0.0)}, RfidTag::kNothing};
}

TEST(Tags, OneInsideSomethingIsRefusedWithItsNameAndPlace) {
  const World world = world_with_block();
  EXPECT_NO_THROW(check_tag(world, tag_at("t", 0.99, 0.0, 0.5)));
  EXPECT_NO_THROW(check_tag(world, tag_at("t", 1.5, 0.0, 1.01)));
  EXPECT_INPUT_ERROR(check_tag(world, tag_at("t", 1.01, 0.0, 0.5)),
                     "tag 't' lies inside 'safe' at (1.01 m, 0.00 m, 0.50 m)");
}

TEST(Tags, IdsAreWordsAndEachIsThatOfOneTag) {
  World world = world_with_block();
  world.tags = {tag_at("t", 0.0, 0.0, 0.5)};
  EXPECT_INPUT_ERROR(check_tag(world, tag_at("t", 0.0, 1.0, 0.5)), "a second tag is called 't'");
  for (const char* id : {"", "two words", "blank "}) {
    EXPECT_INPUT_ERROR(check_tag(world, tag_at(id, 0.0, 1.0, 0.5)), "is not one word");
  }
}

TEST(Tags, WhatIsRightBehindOneHoldsIt) {
  const World world = world_with_block();
  const int metal = material_index(world, "metal");
  EXPECT_EQ(material_behind(world, tag_at("", 0.95, 0.0, 0.5, 3.14159).world_from_tag), metal);
  EXPECT_EQ(material_behind(world, tag_at("", 0.95, 0.0, 0.5, 0.0).world_from_tag),
            RfidTag::kNothing);
  EXPECT_EQ(material_behind(world, tag_at("", 0.85, 0.0, 0.5, 3.14159).world_from_tag),
            RfidTag::kNothing);
}

TEST(OfficeTags, StickOnTheRingsWallsApartFromEachOtherAndFromDoors) {
  OfficeOptions options;
  options.tags = 100;
  const World world = build_office(options);
  ASSERT_EQ(world.tags.size(), 100u);
  EXPECT_EQ(world.tags[16].id, "tag_017");
  const double out = options.room_depth, in = out + options.corridor_width;
  double closest = 100.0;
  for (const RfidTag& tag : world.tags) {
    const Eigen::Vector3d& at = tag.world_from_tag.position;
    EXPECT_GE(at.z(), 1.0);
    EXPECT_LE(at.z(), 1.6);
    // In the corridor, and looking across it: half a metre on, it still is.
    for (const double ahead : {0.0, 0.5}) {
      const Eigen::Vector3d p = tag.world_from_tag * Eigen::Vector3d(ahead, 0.0, 0.0);
      const double edge = std::min({p.x(), p.y(), options.size - p.x(), options.size - p.y()});
      EXPECT_GT(edge, out) << tag.id;
      EXPECT_LT(edge, in) << tag.id;
    }
    EXPECT_EQ(material_behind(world, tag.world_from_tag), tag.material) << tag.id;
    for (const Door& door : world.doors) {
      const Eigen::Vector2d middle = door.world_from_hinge * Eigen::Vector2d(door.width / 2, 0.0);
      EXPECT_GT((at.head<2>() - middle).norm(), 0.7) << tag.id;
    }
    for (const RfidTag& other : world.tags) {
      if (&other == &tag) continue;
      closest = std::min(closest, (at - other.world_from_tag.position).norm());
    }
  }
  // 84 m of walls less doors: some 60 m, pieces of 0.6 m of which the middle 60 % are used.
  EXPECT_GT(closest, 0.2);
}

TEST(OfficeTags, LeaveTheOfficeAsItWas) {
  OfficeOptions options;
  const World without = build_office(options);
  options.tags = 30;
  const World with = build_office(options);
  ASSERT_EQ(with.entities.size(), without.entities.size());
  for (std::size_t i = 0; i < with.entities.size(); ++i) {
    EXPECT_EQ(with.entities[i].world_from_entity, without.entities[i].world_from_entity);
  }
}

}  // namespace
}  // namespace mapbed
