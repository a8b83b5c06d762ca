#include "sim/sensors/rfid/antenna_pattern.h"

#include <cmath>

#include <gmock/gmock.h>

#include "core/geometry/angle.h"
#include "sim/sensors/rfid/fresnel.h"

namespace mapbed {
namespace {

TEST(AntennaPattern, LosesHalfThePowerAtHalfTheBeamWidthAndNoMoreThanFrontToBack) {
  const RfidModel model;
  EXPECT_EQ(antenna_loss(model, 0.0), 0.0);
  EXPECT_NEAR(antenna_loss(model, radians(35.0)), 3.0, 1e-9);
  EXPECT_NEAR(antenna_loss(model, radians(47.5)), 12.0 * std::pow(47.5 / 70.0, 2), 1e-9);
  EXPECT_EQ(antenna_loss(model, kPi), 15.0);
}

// Textbook values: the half power width of such a dipole is 78 deg.
TEST(AntennaPattern, ADipoleHearsNothingAlongItsAxisAndHalfThePower39DegreesOffBroadside) {
  EXPECT_NEAR(dipole_amplitude(0.0), 1.0, 1e-12);
  EXPECT_EQ(dipole_amplitude(1.0), 0.0);
  EXPECT_NEAR(std::pow(dipole_amplitude(std::cos(radians(51.0))), 2), 0.5, 0.01);
}

TEST(AntennaPattern, SpecimensDifferByTheirNumberAloneAndStayAsTheyAre) {
  RfidModel model;
  EXPECT_EQ(device_of(model).gain, 0.0);
  EXPECT_EQ(device_of(model).boresight, Eigen::Vector3d::UnitX());
  double sum = 0.0, off = 0.0;
  constexpr int kDevices = 2000;
  for (int device = 1; device <= kDevices; ++device) {
    model.device = device;
    EXPECT_EQ(device_of(model).gain, device_of(model).gain);
    sum += std::pow(device_of(model).gain, 2);
    off += std::pow(std::acos(device_of(model).boresight.x()), 2);
  }
  // Variances of n draws are off by sqrt(2 / n) of themselves: five of that.
  const double five = 5.0 * std::sqrt(2.0 / kDevices);
  EXPECT_NEAR(sum / kDevices, std::pow(model.gain_spread, 2), five * std::pow(0.7, 2));
  EXPECT_NEAR(off / kDevices, 2.0 * std::pow(model.pointing_spread, 2),
              five * 2.0 * std::pow(model.pointing_spread, 2));
}

Material of(double permittivity) {
  return {.permittivity = permittivity};
}

TEST(Fresnel, AlongTheNormalBothWavesAreSentBackByOneMinusNOverOnePlusN) {
  for (const double permittivity : {1.0, 2.0, 5.31, 81.0}) {
    const double n = std::sqrt(permittivity);
    const Reflection mirror = reflection_of(of(permittivity), 1.0);
    EXPECT_NEAR(mirror.te, (1.0 - n) / (1.0 + n), 1e-12);
    EXPECT_NEAR(mirror.tm, -(1.0 - n) / (1.0 + n), 1e-12);  // by its own axes
  }
}

TEST(Fresnel, AlongTheSurfaceBothAreSentBackWhollyAndTurnedRound) {
  const Reflection mirror = reflection_of(of(5.31), 1e-9);
  EXPECT_NEAR(mirror.te, -1.0, 1e-8);
  EXPECT_NEAR(mirror.tm, -1.0, 1e-7);
}

TEST(Fresnel, AtBrewstersAngleNothingComesBackOfTheWaveInThePlaneOfIncidence) {
  for (const double permittivity : {1.99, 2.94, 5.31}) {
    const double angle = std::atan(std::sqrt(permittivity));
    const Reflection mirror = reflection_of(of(permittivity), std::cos(angle));
    EXPECT_NEAR(mirror.tm, 0.0, 1e-12);
    EXPECT_LT(mirror.te, -0.1);
  }
}

TEST(Fresnel, MetalSendsAllBack) {
  const Reflection mirror = reflection_of({.conductor = true}, 0.3);
  EXPECT_EQ(mirror.te, -1.0);
  EXPECT_EQ(mirror.tm, 1.0);
}

}  // namespace
}  // namespace mapbed
