#include "core/log/ros/unrounded.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/geometry/pose3.h"
#include "core/random.h"

namespace mapbed {
namespace {

TEST(Unrounded, ReadingsAreTheDecimalsThatLasersTell) {
  for (const double told :
       {0.0, 0.02, 2.37, 4.095, 7.123456, 12.3456, 23.4567, 29.999, 81.83, 163.1, 4093.0})
    EXPECT_EQ(unrounded(static_cast<float>(told)), told);
}

TEST(Unrounded, AllAreStoredAsTheFloatThatTheyComeFrom) {
  Rng rng(1);
  for (int trial = 0; trial < 2000; ++trial) {
    const auto value = static_cast<float>(std::pow(10.0, 20.0 * rng.uniform() - 10.0));
    EXPECT_EQ(static_cast<float>(unrounded(value)), value);
    EXPECT_EQ(static_cast<float>(unrounded_bearing(-value)), -value);
  }
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float value : {kInfinity, -kInfinity, std::numeric_limits<float>::max()}) {
    EXPECT_EQ(unrounded(value), static_cast<double>(value));
    EXPECT_EQ(static_cast<float>(unrounded_bearing(value)), value);
  }
  EXPECT_TRUE(std::isnan(unrounded(std::nanf(""))));
  EXPECT_TRUE(std::isnan(unrounded_bearing(std::nanf(""))));
}

TEST(Unrounded, BearingsAreFractionsOfADegree) {
  for (const double told :
       {-90.0, -119.53125, -134.75, -119.885, 0.25, 0.5, 1.0, 1.0 / 3.0, 45.0 / 128.0, 0.1125})
    EXPECT_EQ(unrounded_bearing(static_cast<float>(radians(told))), radians(told)) << told;
}

TEST(Unrounded, BearingsThatWereToldAsDecimalsOfRadiansAreThese) {
  for (const double told : {-1.570796, -2.35619, 0.017453, 0.00613592})
    EXPECT_EQ(unrounded_bearing(static_cast<float>(told)), told);
}

TEST(Unrounded, AHeadingThatWasADecimalIsItAgain) {
  for (int k = -3141592; k < 3141592; k += 1234) {
    const Pose2 told{1.5, -0.1, k / 1e6};
    EXPECT_EQ(unrounded_plan(upright(told)), told);
  }
}

TEST(Unrounded, AnyOtherHeadingStaysWhatItIs) {
  Rng rng(1);
  for (int trial = 0; trial < 1000; ++trial) {
    const Pose2 told{0.0, 0.0, kPi * (2.0 * rng.uniform() - 1.0)};
    EXPECT_NEAR(unrounded_plan(upright(told)).theta, told.theta, 2e-15);
  }
}

TEST(Unrounded, MountsAreTurnedByFractionsOfADegree) {
  for (const double told : {0.0, 12.5, -45.0, 179.9, 180.0}) {
    EXPECT_EQ(unrounded_mount_angle(radians(told) + 4e-10), radians(told)) << told;
    EXPECT_EQ(unrounded_mount_angle(radians(told) - 4e-10), radians(told)) << told;
  }
  EXPECT_EQ(unrounded_mount_angle(0.1234567891), 0.123456789);
  EXPECT_FALSE(std::signbit(unrounded_mount_angle(-1e-12)));
}

}  // namespace
}  // namespace mapbed
