#include "sim/sensors/ideal_laser.h"

#include <cmath>

#include "core/geometry/angle.h"
#include "sim/testing/small_world.h"

namespace mapbed {
namespace {

MountedLaser single_beam() {
  MountedLaser laser;
  laser.model.beams = 1;
  laser.model.first_bearing = 0.0;
  laser.model.max_range = 50.0;
  laser.robot_from_laser.z = 0.4;
  return laser;
}

BeamEchoes sent(const World& world, const MountedLaser& laser, const Pose2& robot) {
  Scene scene(world);
  scene.update();
  const AimedBeam beam{0, robot};
  return cast_beams(scene, laser, {&beam, 1}).front();
}

TEST(IdealLaser, AWallIsOneEchoWithRangeIncidenceAndMaterial) {
  const World world = small_room(6.0, 4.0);
  const BeamEchoes beam = sent(world, single_beam(), {1.0, 2.0, radians(30.0)});
  ASSERT_EQ(beam.echoes.size(), 1u);
  // The north wall at y = 4 is 2 m / sin(30 deg) away.
  EXPECT_NEAR(beam.truth.range, 4.0, 1e-5);
  EXPECT_NEAR(beam.echoes[0].range, 4.0, 1e-5);
  EXPECT_NEAR(beam.echoes[0].cos_incidence, std::sin(radians(30.0)), 1e-5);
  EXPECT_EQ(beam.echoes[0].fraction, 1.0F);
  EXPECT_EQ(beam.truth.entity, 1);  // the north wall
  EXPECT_FLOAT_EQ(beam.echoes[0].reflectivity, static_cast<float>(world.materials[0].reflectivity));
}

TEST(IdealLaser, TheMountMovesTheBeam) {
  MountedLaser laser = single_beam();
  laser.robot_from_laser.planar = {0.5, 0.0, kPi / 2.0};
  EXPECT_NEAR(sent(small_room(6.0, 4.0), laser, {1.0, 2.0, 0.0}).truth.range, 2.0, 1e-5);
}

// Looking down by 10 degrees from 0.4 m, the axis meets the floor at 0.4 m / sin(10 deg), the beam
// at bearing b where its slope sin(10 deg) cos(b) takes it down as far.
TEST(IdealLaser, ATiltedOneSeesTheFloorAheadOfIt) {
  World world = small_room(20.0, 20.0);
  add_floor(world);
  MountedLaser laser = single_beam();
  laser.robot_from_laser.pitch = radians(10.0);
  for (const double bearing : {0.0, radians(40.0), radians(-40.0)}) {
    laser.model.first_bearing = bearing;
    const BeamEchoes beam = sent(world, laser, {5.0, 10.0, radians(20.0)});
    EXPECT_NEAR(beam.truth.range, 0.4 / (std::sin(radians(10.0)) * std::cos(bearing)), 1e-5);
    EXPECT_EQ(beam.truth.entity, 4);  // the floor
    EXPECT_NEAR(beam.echoes[0].cos_incidence, std::sin(radians(10.0)) * std::cos(bearing), 1e-5);
  }
  // Straight to the left it runs level, to the right too: walls, not the floor.
  laser.model.first_bearing = kPi / 2.0;
  EXPECT_NEAR(sent(world, laser, {5.0, 10.0, 0.0}).truth.range, 10.0, 1e-5);
}

TEST(IdealLaser, ALaserThatIsRolledSeesTheFloorOnOneSide) {
  World world = small_room(20.0, 20.0);
  add_floor(world);
  MountedLaser laser = single_beam();
  laser.robot_from_laser.roll = radians(30.0);
  laser.model.first_bearing = -kPi / 2.0;  // to the right, which a positive roll lowers
  EXPECT_NEAR(sent(world, laser, {10.0, 10.0, 0.0}).truth.range, 0.8, 1e-5);
}

TEST(IdealLaser, ASpotOnAnEdgeIsDividedByTheChordsOfADisc) {
  World world = small_room(6.0, 4.0);
  world.entities.push_back(block("box", {3.0, 1.0}, {1.0, 2.0}));  // its corner at (2.5, 2)
  MountedLaser laser = single_beam();
  laser.model.aperture = 0.05;
  laser.model.divergence = 0.0;
  laser.model.sub_rays = 5;
  // The axis runs along y = 2.004: the two right sub-rays, at 1 and 2 cm, meet the box.
  const BeamEchoes beam = sent(world, laser, {1.0, 2.004, 0.0});
  ASSERT_EQ(beam.echoes.size(), 5u);
  double on_box = 0.0;
  double total = 0.0;
  for (const Echo& echo : beam.echoes) {
    total += echo.fraction;
    if (echo.range < 2.0F) on_box += echo.fraction;
  }
  const double chords[] = {0.6, std::sqrt(1 - 0.16), 1.0};
  const double sum = 2 * chords[0] + 2 * chords[1] + chords[2];
  EXPECT_NEAR(total, 1.0, 1e-6);
  EXPECT_NEAR(on_box, (chords[0] + chords[1]) / sum, 1e-6);
  EXPECT_NEAR(beam.truth.range, 5.0, 1e-5);  // the axis passes
}

TEST(IdealLaser, BehindAPaneFollowsTheWall) {
  World world = small_room(6.0, 4.0);
  const int glass = material_index(world, "glass");
  world.entities.push_back(block("pane", {3.0, 2.0}, {0.02, 3.0}, glass));
  const BeamEchoes beam = sent(world, single_beam(), {1.0, 2.0, 0.0});
  ASSERT_EQ(beam.echoes.size(), 2u);
  EXPECT_NEAR(beam.echoes[0].range, 1.99, 1e-5);
  EXPECT_NEAR(beam.echoes[1].range, 5.0, 1e-5);
  const Material& pane = world.materials[static_cast<std::size_t>(glass)];
  EXPECT_FLOAT_EQ(beam.echoes[0].hit_probability, static_cast<float>(pane.specular_hit));
  EXPECT_EQ(beam.echoes[1].hit_probability, 1.0F);
  EXPECT_EQ(beam.truth.material, glass);
}

TEST(IdealLaser, NothingInReachIsAnInfiniteEcho) {
  MountedLaser laser = single_beam();
  laser.model.max_range = 2.0;
  const BeamEchoes beam = sent(small_room(6.0, 4.0), laser, {1.0, 2.0, 0.0});
  EXPECT_EQ(beam.truth.entity, -1);
  ASSERT_EQ(beam.echoes.size(), 1u);
  EXPECT_TRUE(std::isinf(beam.echoes[0].range));
}

}  // namespace
}  // namespace mapbed
