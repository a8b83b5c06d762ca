#include "algorithms/rfid/strength_fit.h"

#include <cmath>

#include <gtest/gtest.h>

#include "algorithms/rfid/robust_fit.h"
#include "core/random.h"

namespace mapbed {
namespace {

StrengthModel known_model() {
  StrengthModel model;
  for (int i = 0; i < 2; ++i) {
    SpatialAntenna a;
    a.azimuth = i == 0 ? radians(170.0) : radians(-60.0);
    a.elevation = radians(40.0);
    a.beam_width = radians(65.0);
    a.back = 14.0;
    a.level = -60.0 - i;
    a.falloff = 22.0;
    model.antennas.push_back(a);
  }
  model.tags = {2.0, -0.5, -1.5};
  return model;
}

// Of every tag at each place of a lattice, by every antenna, with noise of this sigma [dB].
std::vector<StrengthReading> readings_of(const StrengthModel& model, double sigma) {
  std::vector<StrengthReading> readings;
  Rng rng(3);
  for (double x = -2.0; x <= 2.0; x += 0.5) {
    for (double y = -2.0; y <= 2.0; y += 0.5) {
      for (const double z : {0.5, 1.0, 1.5, 2.0, 2.5}) {
        for (int antenna = 0; antenna < 2; ++antenna) {
          for (int tag = 0; tag < 3; ++tag) {
            const Eigen::Vector3d place(x, y, z);
            const double noise = sigma > 0.0 ? rng.normal(0.0, sigma) : 0.0;
            readings.push_back(
                {antenna, tag, place, expected_strength(model, antenna, tag, place) + noise});
          }
        }
      }
    }
  }
  return readings;
}

TEST(StrengthModel, LosesThreeDecibelsAtHalfTheBeamWidth) {
  SpatialAntenna a;
  a.azimuth = radians(30.0);
  a.elevation = radians(20.0);
  EXPECT_NEAR(angle_off_boresight(a, 2.0 * boresight(a)), 0.0, 1e-7);
  a.elevation += 0.5 * a.beam_width;
  const Eigen::Vector3d aside = boresight(a);
  a.elevation -= 0.5 * a.beam_width;
  EXPECT_NEAR(beam_loss(a, aside), 3.0, 1e-9);
  EXPECT_NEAR(beam_loss(a, -aside), a.back, 1e-9);
}

// With as much reflected as comes straight, out of phase by half a turn, nothing is left; in
// phase, four times the power each way.
TEST(StrengthModel, RaysByAReflectorAddAsFields) {
  StrengthModel model;
  SpatialAntenna a;
  a.back = a.falloff = 0.0;
  model.antennas = {a};
  model.tags = {0.0};
  const Eigen::Vector3d place(4.0, 0.0, 0.0);
  model.reflector = {.height = -1.5, .factor = 1.0, .wavelength = 1.0};  // by 5 m: one turn more
  EXPECT_NEAR(expected_strength(model, 0, 0, place), a.level + 40.0 * std::log10(2.0), 1e-9);
  model.reflector.wavelength = 2.0;
  EXPECT_LT(expected_strength(model, 0, 0, place), a.level - 60.0);
}

// At the threshold half of a normal distribution is left, whose mean is sqrt(2 / pi) sigma above.
TEST(StrengthModel, WhatIsReadIsStrongerThanTheLinkBudgetSays) {
  const ReadThreshold threshold{.least = -80.0, .sigma = 3.0};
  EXPECT_NEAR(mean_of_read(threshold, -80.0), -80.0 + 3.0 * std::sqrt(2.0 / kPi), 1e-9);
  EXPECT_NEAR(mean_of_read(threshold, -40.0), -40.0, 1e-9);
  const double weakest = mean_of_read(threshold, -300.0);
  EXPECT_GT(weakest, -80.0);
  EXPECT_LT(weakest, -79.8);
  EXPECT_EQ(mean_of_read({}, -100.0), -100.0);
}

TEST(RobustFit, IsTheMedianOfFewWhereResidualsAreWide) {
  const std::vector<double> values{1.0, 2.0, 4.0, 80.0, 90.0};
  const auto residuals = [&](const std::vector<double>& at) {
    std::vector<double> result;
    for (const double value : values) result.push_back(at[0] - value);
    return result;
  };
  // Within 1 of its answer lies 4 alone: two pull down, two up. The cost, about 160, is least to
  // 1e-8 of itself: within sqrt(2 * 160e-8) of the answer.
  EXPECT_NEAR(robust_fit(residuals, {{10.0}}, {.width = 1.0})[0], 4.0, 2e-3);
  EXPECT_NEAR(robust_fit(residuals, {{10.0}}, {.width = 1e6})[0], 35.4, 1e-4);
  EXPECT_NEAR(robust_fit(residuals, {{10.0, 0.0, 20.0}}, {.width = 1e6})[0], 20.0, 1e-9);
}

TEST(StrengthFit, FindsWhatMadeReadingsWithoutNoise) {
  const StrengthModel truth = known_model();
  const StrengthModel found = fitted_strength(readings_of(truth, 0.0), 2, 3);
  for (std::size_t i = 0; i < 2; ++i) {
    const SpatialAntenna &a = found.antennas[i], &b = truth.antennas[i];
    EXPECT_NEAR(angle_difference(a.azimuth, b.azimuth), 0.0, 1e-3);
    EXPECT_NEAR(a.elevation, b.elevation, 1e-3);
    EXPECT_NEAR(a.beam_width, b.beam_width, 1e-3);
    EXPECT_NEAR(a.back, b.back, 0.01);
    EXPECT_NEAR(a.level, b.level, 0.01);
    EXPECT_NEAR(a.falloff, b.falloff, 0.02);
  }
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found.tags[i], truth.tags[i], 0.01);
}

// Of 405 places, 1215 readings an antenna with 3 dB: a level's standard deviation is 0.09 dB by
// itself, and some times that beside falloff and beam; four of these, or 0.5 dB. A degree off the
// boresight changes readings at half the width, 33 degrees away, by 12 * 2 * 33 / 65^2 = 0.19 dB,
// so that directions are known to about 0.09 / 0.19 * sqrt(2) = 0.7 degrees: four of these.
TEST(StrengthFit, FindsDirectionsThroughNoise) {
  const StrengthModel truth = known_model();
  std::vector<StrengthReading> readings = readings_of(truth, 3.0);
  // What fades out of all bounds now and then draws at little.
  for (std::size_t i = 0; i < readings.size(); i += 50) readings[i].strength -= 25.0;
  const StrengthModel found = fitted_strength(readings, 2, 3);
  for (std::size_t i = 0; i < 2; ++i) {
    const SpatialAntenna &a = found.antennas[i], &b = truth.antennas[i];
    EXPECT_NEAR(angle_difference(a.azimuth, b.azimuth), 0.0, radians(2.8));
    EXPECT_NEAR(a.elevation, b.elevation, radians(5.6));  // places are above it alone
  }
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found.tags[i], truth.tags[i], 0.5);
}

// An antenna 0.1 m to the side is as one that is turned by 3 degrees, for places 2 m away: four
// times the 0.7 degrees are 0.1 m, and more with both free.
TEST(StrengthFit, FindsTheAntennasPlaces) {
  StrengthModel truth = known_model();
  truth.antennas[0].position = {0.3, -0.2, -0.4};
  const StrengthModel found = fitted_strength(readings_of(truth, 1.0), 2, 3, {.position = true});
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT((found.antennas[i].position - truth.antennas[i].position).norm(), 0.15);
  }
}

TEST(StrengthFit, FindsTheThresholdBelowWhichNothingIsRead) {
  StrengthModel truth = known_model();
  truth.threshold = {.least = -76.0, .sigma = 3.0};
  const StrengthModel found = fitted_strength(readings_of(truth, 0.0), 2, 3, {.threshold = true});
  EXPECT_NEAR(found.threshold.least, -76.0, 0.1);
  EXPECT_NEAR(found.threshold.sigma, 3.0, 0.1);
  EXPECT_NEAR(found.antennas[0].falloff, 22.0, 0.3);
}

TEST(StrengthFit, FindsTheFloor) {
  StrengthModel truth = known_model();
  truth.reflector = {.height = -0.7, .factor = -0.4};
  const StrengthModel found = fitted_strength(readings_of(truth, 0.5), 2, 3, {.reflector = true});
  EXPECT_NEAR(found.reflector.height, -0.7, 0.01);
  EXPECT_NEAR(found.reflector.factor, -0.4, 0.05);
}

}  // namespace
}  // namespace mapbed
