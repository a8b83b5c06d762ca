#include "robots/laser_model.h"

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

TEST(LaserModel, HalfATurnOfTheMirrorTakesHalfItsPeriod) {
  LaserModel laser;
  laser.beams = 181;
  laser.bearing_step = radians(1.0);
  laser.mirror_rate = 75.0;

  EXPECT_DOUBLE_EQ(laser.beam_delay(0), 0.0);
  EXPECT_NEAR(laser.beam_delay(180), 0.5 / 75.0, 1e-12);
  EXPECT_NEAR(laser.sweep_time(), 0.5 / 75.0, 1e-12);
}

TEST(LaserModel, InterlacedBeamsBelongToTheNextTurn) {
  LaserModel laser;
  laser.beams = 361;
  laser.bearing_step = radians(0.5);
  laser.interlace = 2;

  // Beam 359 at 179.5 deg is the last of the second turn.
  EXPECT_NEAR(laser.beam_delay(1) - laser.beam_delay(0), (1.0 + 0.5 / 360.0) / 75.0, 1e-12);
  EXPECT_NEAR(laser.sweep_time(), (1.0 + 179.5 / 360.0) / 75.0, 1e-12);
}

TEST(LaserModel, AStampIsThatOfTheFirstBeamUnlessAllCountAsOneInstant) {
  LaserModel laser;
  laser.mirror_rate = 10.0;  // half a turn takes 50 ms, but for the last degree
  EXPECT_EQ(laser.stamp_delay(), 0.0);
  laser.stamp = SweepStamp::middle;
  EXPECT_NEAR(laser.stamp_delay(), 0.025, 0.001);
  laser.stamp = SweepStamp::first_beam;
  laser.interlace = 2;  // of which no log can tell when each beam was sent
  EXPECT_NEAR(laser.stamp_delay(), laser.sweep_time() / 2.0, 1e-12);
}

TEST(LaserModel, WithoutAMirrorAllBeamsGoAtOnce) {
  LaserModel laser;
  laser.mirror_rate = 0.0;
  EXPECT_EQ(laser.sweep_time(), 0.0);
}

}  // namespace
}  // namespace mapbed
