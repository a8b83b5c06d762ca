#include "sim/sensors/rfid/rfid_field.h"

#include <cmath>

#include <gmock/gmock.h>

#include "core/geometry/angle.h"
#include "sim/testing/small_world.h"

namespace mapbed {
namespace {

using Eigen::Vector3d;

// What a tag receives of one antenna of the model in a world.
IdealTag received(const World& world, const RfidModel& model, const Pose3& antenna,
                  const RfidTag& tag) {
  const Scene scene(world);
  const RfidField field(world, {{.model = model}});
  return field.at(scene, 0, antenna, tag).value_or(IdealTag{.power = -1e9F});
}

Pose3 at(double x, double y, double z, double heading = 0.0) {
  return {{x, y, z}, rotation_of(heading, 0.0, 0.0)};
}

// Looks along -x, its dipole level; `roll` turns the dipole about that.
RfidTag tag_at(double x, double y, double z, double roll = 0.0) {
  return {"t", {{x, y, z}, rotation_of(kPi, 0.0, roll)}, RfidTag::kNothing};
}

RfidModel everywhere_alike() {
  RfidModel model;
  model.front_to_back = 0.0;
  model.threshold = -60.0;  // nothing is too weak
  return model;
}

// Friis: 36 + 2 - 3 - 20 log10(4 pi / 0.32764) = 3.32 dBm at 1 m, 6.02 dB less at twice that.
TEST(RfidField, InFreeSpacePowerIsThatOfFriis) {
  const World nothing;
  const RfidModel model;
  const double wavelength = 299'792'458.0 / 915e6;
  const double at_one = 35.0 - 20.0 * std::log10(4.0 * kPi / wavelength);
  EXPECT_NEAR(at_one, 3.32, 0.01);
  for (const double d : {1.0, 2.0, 5.0}) {
    const IdealTag tag = received(nothing, model, at(0, 0, 1), tag_at(d, 0, 1));
    EXPECT_NEAR(tag.power, at_one - 20.0 * std::log10(d), 1e-4);
    EXPECT_NEAR(tag.multipath, 0.0, 1e-5);
    // Of there and back; a dipole across `up` is a quarter of a period late, twice.
    const double turns = 2.0 * d / wavelength + 0.5;
    EXPECT_NEAR(std::cos(tag.phase), std::cos(2.0 * kPi * turns), 1e-3);
  }
}

// The three-part model of the thesis: where half the tags answer. 5 cm of 3.2 m are 0.14 dB.
TEST(RfidField, TheThresholdIsMetSixMetresAheadThreeAsideAndOneBehind) {
  const World nothing;
  const RfidModel model;
  const auto power = [&](double distance, double bearing) {
    RfidTag tag = tag_at(distance * std::cos(bearing), distance * std::sin(bearing), 1.0);
    tag.world_from_tag.rotation = rotation_of(bearing + kPi, 0.0, 0.0);
    return received(nothing, model, at(0, 0, 1), tag).power;
  };
  EXPECT_NEAR(power(6.0, 0.0), model.threshold, 0.1);
  EXPECT_NEAR(power(3.2, radians(47.5)), model.threshold, 0.14);
  EXPECT_NEAR(power(3.2, radians(-47.5)), model.threshold, 0.14);
  EXPECT_NEAR(power(1.07, kPi), model.threshold, 0.1);
}

World on_metal() {
  World world;
  add_floor(world);
  world.entities[0].parts[0].material = material_index(world, "metal");
  return world;
}

// Antenna and tag 1 m above metal. A dipole across the way: the mirrored wave comes turned round,
// and takes most where its way is n wavelengths longer: d = (4 h^2 - n^2 l^2) / (2 n l).
TEST(RfidField, OverMetalTheTwoRaysCancelWhereTheirWaysDifferByWholeWavelengths) {
  const World world = on_metal();
  const RfidModel model = everywhere_alike();
  const double l = model.wavelength();
  for (const double n : {1.0, 2.0, 3.0, 0.5, 1.5, 2.5}) {
    const double d = (4.0 - n * n * l * l) / (2.0 * n * l);
    const double ratio = d / (d + n * l);
    const bool is_null = n == std::floor(n);
    const IdealTag tag = received(world, model, at(0, 0, 1), tag_at(d, 0, 1));
    EXPECT_NEAR(tag.multipath, 20.0 * std::log10(is_null ? 1.0 - ratio : 1.0 + ratio), 0.01) << n;
    EXPECT_FALSE(tag.is_reflection);
  }
}

// An upright dipole's image stands upright, too: there the ways add up. It hears the mirrored wave
// less, which comes from below.
TEST(RfidField, OverMetalAnUprightDipoleGetsMostWhereALevelOneGetsNothing) {
  const World world = on_metal();
  const RfidModel model = everywhere_alike();
  const double l = model.wavelength();
  const double d = (4.0 - l * l) / (2.0 * l);
  const double d1 = d + l;
  const double psi = std::acos(2.0 / d1);  // between the wave and the upright axis
  const double heard = std::cos(kPi / 2.0 * std::cos(psi)) / std::sin(psi);
  const IdealTag tag = received(world, model, at(0, 0, 1), tag_at(d, 0, 1, kPi / 2.0));
  EXPECT_NEAR(tag.multipath, 20.0 * std::log10(1.0 + heard * d / d1), 0.01);
}

TEST(RfidField, AnAntennaAndATagMayChangePlaces) {
  World room = small_room(6.0, 4.0);
  add_floor(room);
  room.entities.push_back(block("column", {3.0, 2.0}, {0.4, 0.4}));
  RfidModel model = everywhere_alike();
  model.reflections = 2;
  model.orientation = model.polarization = false;
  const Vector3d a(1.0, 1.1, 0.6), b(4.7, 2.9, 1.4);
  const IdealTag there = received(room, model, {a, rotation_of(0.3, 0.0, 0.0)},
                                  {"t", {b, rotation_of(1.0, 0.0, 0.0)}});
  const IdealTag back = received(room, model, {b, rotation_of(2.0, 0.0, 0.0)},
                                 {"t", {a, rotation_of(-1.0, 0.0, 0.0)}});
  EXPECT_NEAR(there.power, back.power, 1e-4);
  EXPECT_NEAR(std::cos(there.phase - back.phase), 1.0, 1e-6);
  EXPECT_GT(std::abs(there.multipath), 0.01);
}

// A plate of wood across the way and one of brick, of which nothing else is near.
TEST(RfidField, WhatStandsInTheWayTakesItsLossOnceAThing) {
  World world;
  const RfidModel model;
  const IdealTag free = received(world, model, at(0, 0, 1), tag_at(4, 0, 1));
  world.entities = {block("board", {1.0, 0.0}, {0.05, 0.3}, material_index(world, "wood")),
                    block("wall", {2.0, 0.0}, {0.2, 0.3}, material_index(world, "brick"))};
  RfidModel straight = model;
  straight.reflections = 0;
  const IdealTag tag = received(world, straight, at(0, 0, 1), tag_at(4, 0, 1));
  EXPECT_NEAR(tag.crossing, 2.5 + 7.0, 1e-6);
  EXPECT_NEAR(tag.power, free.power - 9.5, 1e-4);
  EXPECT_EQ(tag.direct, free.direct);
}

TEST(RfidField, WhoStandsInTheWayTakesTheLossOfClothes) {
  World world;
  Scene scene(world);
  const RfidField field(world, {{}});
  const Pose3 antenna = at(0, 0, 1);
  const float free = field.at(scene, 0, antenna, tag_at(4, 0, 1))->power;
  Entity person{.name = "somebody", .kind = EntityKind::person};
  person.parts = {
      {"trunk", Cylinder{0.2, 1.8}, upright({}, 0.9), material_index(world, "clothes")}};
  person.world_from_entity = upright({2.0, 0.0, 0.0});
  const int id = scene.add(person);
  scene.update();
  EXPECT_NEAR(field.at(scene, 0, antenna, tag_at(4, 0, 1))->power, free - 10.0, 1e-4);
  scene.move(id, upright({2.0, 1.0, 0.0}));
  scene.update();
  EXPECT_NEAR(field.at(scene, 0, antenna, tag_at(4, 0, 1))->power, free, 1e-4);
}

// Behind a metal plate that the straight way does not get through, by a mirror at the side.
TEST(RfidField, ATagBehindMetalIsReachedByAMirror) {
  World world;
  const int metal = material_index(world, "metal");
  world.entities = {block("plate", {2.0, 0.0}, {0.05, 1.0}, metal),
                    block("mirror", {2.0, 2.1}, {4.0, 0.2}, metal)};
  const RfidModel model = everywhere_alike();
  const IdealTag tag = received(world, model, at(0, 0, 1), tag_at(4, 0, 1));
  EXPECT_TRUE(tag.is_reflection);
  // The mirror's face is at y = 2: there and back 2 sqrt(2^2 + 2^2) against 4, and the dipole hears
  // it 45 deg off broadside.
  const double heard = std::cos(kPi / 2.0 * std::sqrt(0.5)) / std::sqrt(0.5);
  const double expected = 20.0 * std::log10(heard / std::sqrt(2.0));
  EXPECT_NEAR(tag.power - tag.direct, expected, 0.6);  // 30 dB less come straight: 3 %
  world.entities.pop_back();
  EXPECT_FALSE(received(world, model, at(0, 0, 1), tag_at(4, 0, 1)).is_reflection);
}

class EachMechanism : public ::testing::Test {
 protected:
  EachMechanism() : world_(small_room(8.0, 4.0)) {
    add_floor(world_);
    world_.entities.back().parts[0].material = material_index(world_, "metal");
    world_.entities.push_back(
        block("screen", {3.0, 2.0}, {0.1, 0.5}, material_index(world_, "wood")));
    tag_ = tag_at(5.0, 2.4, 1.4, 0.4);
    tag_.material = material_index(world_, "concrete");
  }
  IdealTag with(const RfidModel& model) const {
    return received(world_, model, at(1, 2, 0.6), tag_);
  }

  World world_;
  RfidTag tag_;
  RfidModel model_;
};

TEST_F(EachMechanism, ReflectionsTurnedOffLeaveTheStraightWay) {
  const IdealTag all = with(model_);
  ASSERT_GT(std::abs(all.multipath), 0.1);
  model_.reflections = 0;
  const IdealTag straight = with(model_);
  EXPECT_EQ(straight.direct, all.direct);
  EXPECT_EQ(straight.crossing, all.crossing);
  EXPECT_NEAR(straight.multipath, 0.0, 1e-5);
  model_.reflections = 2;
  EXPECT_GT(std::abs(with(model_).multipath - all.multipath), 1e-3);
}

TEST_F(EachMechanism, TheFloorTurnedOffIsAsIfThereWereNone) {
  const IdealTag all = with(model_);
  model_.floor = false;
  const IdealTag off = with(model_);
  model_.floor = true;
  std::erase_if(world_.entities, [](const Entity& e) { return e.kind == EntityKind::floor; });
  const IdealTag none = with(model_);
  EXPECT_EQ(off.power, none.power);
  EXPECT_EQ(off.direct, all.direct);
  EXPECT_GT(std::abs(off.power - all.power), 0.1);
}

TEST_F(EachMechanism, OcclusionTurnedOffTakesNothingOfTheStraightWay) {
  const IdealTag all = with(model_);
  ASSERT_NEAR(all.crossing, 2.5, 1e-6);
  model_.reflections = 0;
  model_.occlusion = false;
  const IdealTag off = with(model_);
  EXPECT_EQ(off.crossing, 0.0F);
  EXPECT_EQ(off.direct, all.direct);
  EXPECT_NEAR(off.power, all.direct, 1e-5);
}

TEST_F(EachMechanism, WhatIsBehindATagTurnedOffGivesItsLossBack) {
  const IdealTag all = with(model_);
  model_.backing = false;
  const IdealTag off = with(model_);
  EXPECT_NEAR(off.power, all.power + 3.0, 1e-4);
  EXPECT_NEAR(off.multipath, all.multipath, 1e-4);
}

TEST_F(EachMechanism, OrientationTurnedOffLetsATagHearAlongItsAxis) {
  tag_.world_from_tag.rotation = rotation_of(kPi / 2.0, 0.0, 0.0);  // looks aside
  model_.reflections = 0;
  const IdealTag all = with(model_);
  model_.orientation = false;
  const IdealTag off = with(model_);
  const Vector3d way = (tag_.world_from_tag.position - Vector3d(1, 2, 0.6)).normalized();
  const double psi = std::acos(way.x());
  EXPECT_NEAR(off.direct - all.direct,
              -20.0 * std::log10(std::cos(kPi / 2.0 * std::cos(psi)) / std::sin(psi)), 1e-3);
}

TEST_F(EachMechanism, PolarizationTurnedOffGivesItsLossBackOnTheStraightWay) {
  const IdealTag all = with(model_);
  model_.polarization = false;
  const IdealTag off = with(model_);
  EXPECT_NEAR(off.direct, all.direct + 3.0, 1e-4);
  EXPECT_EQ(off.crossing, all.crossing);
  EXPECT_GT(std::abs(off.multipath - all.multipath), 0.01);
}

TEST(RfidField, ARoundHasTheTagsWithinReachByTheirPlaceInTheWorld) {
  World world = small_room(8.0, 4.0);
  world.tags = {tag_at(30.0, 2.0, 1.0), tag_at(4.0, 2.0, 1.0), tag_at(6.0, 1.0, 1.0)};
  world.tags[1].id = "near";
  const Scene scene(world);
  const RfidField field(world, {{.robot_from_antenna = {.planar = {0.1, 0.2, 0.0}, .z = 0.6}}});
  const IdealRfid round = field.round(scene, 0, {1.0, 2.0, kPi / 2.0});
  EXPECT_LT((round.place - Eigen::Vector2d(0.8, 2.1)).norm(), 1e-12);
  ASSERT_EQ(round.tags.size(), 2u);
  EXPECT_EQ(round.tags[0].tag, 1);
  EXPECT_EQ(round.tags[1].tag, 2);
  EXPECT_EQ((*round.names)[1], "near");
}

TEST(RfidField, AWorldWithoutTagsGivesEmptyRounds) {
  const World world = small_room(8.0, 4.0);
  const RfidField field(world, {{}, {}});
  EXPECT_TRUE(field.round(Scene(world), 1, {1.0, 2.0, 0.0}).tags.empty());
}

}  // namespace
}  // namespace mapbed
