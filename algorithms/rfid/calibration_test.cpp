#include "algorithms/rfid/calibration.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace mapbed {
namespace {

// A robot turns in front of the tag at distances up to 9 m; the tag answers as `antenna` says.
std::vector<CalibrationReading> readings_of(const AntennaModel& antenna, std::uint64_t seed = 1) {
  std::vector<CalibrationReading> readings;
  Rng rng(seed);
  for (double distance = 0.3; distance < 9.0; distance += 0.3) {
    for (int k = 0; k < 430; ++k) {
      const double bearing = rng.uniform(-kPi, kPi);
      const Eigen::Vector2d tag(distance * std::cos(bearing), distance * std::sin(bearing));
      CalibrationReading reading{tag, rng.uniform() < detection_probability(antenna, tag)};
      if (const auto* smooth = std::get_if<SmoothAntenna>(&antenna)) {
        reading.rssi = expected_rssi(*smooth, tag) + rng.normal(0.0, smooth->rssi_sigma);
      }
      readings.push_back(reading);
    }
  }
  return readings;
}

TEST(Calibration, FindsThePartsOfAPiecewiseAntenna) {
  const PiecewiseAntenna truth{.direction = radians(5.0),
                               .opening = radians(95.0),
                               .range = 6.05,
                               .disc_radius = 1.1,
                               .arc_rate = 0.8,
                               .disc_rate = 0.9,
                               .elsewhere_rate = 0.02};
  const PiecewiseAntenna found = fitted_piecewise(readings_of(truth));
  EXPECT_NEAR(found.direction, truth.direction, radians(2.6));
  EXPECT_NEAR(found.opening, truth.opening, radians(5.1));
  EXPECT_NEAR(found.range, truth.range, 0.25);  // rings that were looked into are 0.3 m apart
  EXPECT_NEAR(found.disc_radius, truth.disc_radius, 0.25);
  // Of some 2000 rounds in the arc and 1300 in the disc: within four standard deviations.
  EXPECT_NEAR(found.arc_rate, 0.8, 0.036);
  EXPECT_NEAR(found.disc_rate, 0.9, 0.034);
  EXPECT_NEAR(found.elsewhere_rate, 0.02, 0.01);
}

TEST(Calibration, FindsTheParametersOfASmoothAntenna) {
  const SmoothAntenna truth{.direction = radians(-8.0),
                            .beam_width = radians(60.0),
                            .back = 12.0,
                            .level = 14.0,
                            .falloff = 20.0,
                            .softness = 3.0,
                            .most = 0.9,
                            .least = 0.02,
                            .rssi = -47.0,
                            .rssi_falloff = 38.0,
                            .rssi_beam = 1.8,
                            .rssi_sigma = 3.0};
  const SmoothAntenna found = fitted_smooth(readings_of(truth));
  EXPECT_NEAR(found.direction, truth.direction, radians(2.0));
  EXPECT_NEAR(found.most, truth.most, 0.03);
  EXPECT_NEAR(found.least, truth.least, 0.015);
  EXPECT_NEAR(found.rssi, truth.rssi, 0.5);
  EXPECT_NEAR(found.rssi_falloff, truth.rssi_falloff, 1.0);
  // What the beam takes from an answer 20 degrees off, whose share of width and factor is free.
  const auto beam = [&](const SmoothAntenna& a) {
    const double off = truth.direction + radians(20.0);
    return a.rssi - expected_rssi(a, {std::cos(off), std::sin(off)});
  };
  EXPECT_NEAR(beam(found), beam(truth), 0.3);
  EXPECT_NEAR(found.rssi_sigma, truth.rssi_sigma, 0.15);
  // The range ahead and behind, which is what level, falloff and back come to.
  const auto range = [](const SmoothAntenna& a, double loss) {
    return std::pow(10.0, (a.level - loss) / a.falloff);
  };
  EXPECT_NEAR(range(found, 0.0), range(truth, 0.0), 0.2);
  EXPECT_NEAR(range(found, found.back), range(truth, truth.back), 0.15);
}

TEST(Calibration, TheHistogramCountsEachRoundInItsCell) {
  const std::vector<CalibrationReading> readings{
      {{0.6, 0.1}, true}, {{0.9, 0.4}, false}, {{-0.1, -0.1}, true}, {{20.0, 0.0}, true}};
  const HistogramAntenna counted = counted_histogram(readings, {.cell_size = 0.5, .reach = 2.0});
  ASSERT_EQ(counted.cells, 8);
  EXPECT_EQ(counted.rounds[counted.index(5, 4)], 2.0);
  EXPECT_EQ(counted.detections[counted.index(5, 4)], 1.0);
  EXPECT_EQ(counted.rounds[counted.index(3, 3)], 1.0);
  EXPECT_NEAR(counted.elsewhere_rate, 2.0 / 101.0, 1e-12);
}

TEST(Calibration, NothingPredictsHeldOutRoundsBetterThanWhatMadeThem) {
  const SmoothAntenna truth;
  const auto learned_from = readings_of(truth, 1), held_out = readings_of(truth, 2);
  const double best = mean_log_likelihood(truth, held_out);
  const double smooth = mean_log_likelihood(fitted_smooth(learned_from), held_out);
  const double piecewise = mean_log_likelihood(fitted_piecewise(learned_from), held_out);
  const double histogram = mean_log_likelihood(counted_histogram(learned_from), held_out);
  EXPECT_NEAR(smooth, best, 0.003);
  EXPECT_LT(piecewise, smooth);
  EXPECT_LT(histogram, smooth);
  EXPECT_GT(histogram, piecewise);
}

}  // namespace
}  // namespace mapbed
