#include "algorithms/rfid/phase_model.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/random.h"

namespace mapbed {
namespace {

constexpr double kWavelength = 0.346;  // [m]

// Two channels, at places about the antenna, of a tag that lies `shift` beside these.
std::vector<PhaseReading> readings_of(const Eigen::Vector3d& shift, int turns) {
  std::vector<PhaseReading> readings;
  Rng rng(5);
  for (int i = 0; i < 60; ++i) {
    PhaseReading reading{.channel = i % 2, .wavelength = kWavelength, .reads = 10.0};
    reading.place = {rng.uniform(-2.0, 2.0), rng.uniform(-2.0, 2.0), rng.uniform(0.5, 2.5)};
    const double way = 2.0 * (reading.place + shift).norm();
    const double phase = 2.0 * kPi * way / kWavelength + (i % 2 == 0 ? 0.4 : 2.1);
    reading.mean = std::polar(1.0, turns * phase);
    readings.push_back(reading);
  }
  return readings;
}

TEST(PhaseModel, TurnsOnceInHalfAWavelength) {
  PhaseReading reading{.wavelength = kWavelength};
  reading.place = {1.0, 0.0, 0.0};
  const Eigen::Vector3d farther(0.5 * kWavelength, 0.0, 0.0);
  const auto grown = [&](int turns) {
    return expected_phase(reading, farther, turns) -
           expected_phase(reading, Eigen::Vector3d::Zero(), turns);
  };
  EXPECT_NEAR(grown(1), 2.0 * kPi, 1e-9);
  EXPECT_NEAR(grown(2), 4.0 * kPi, 1e-9);
}

TEST(PhaseModel, FindsWhereATagLiesBesideItsPlace) {
  const Eigen::Vector3d shift(0.12, -0.07, 0.03);
  for (const int turns : {1, 2}) {
    const auto readings = readings_of(shift, turns);
    const std::vector<Eigen::Vector3d> none(readings.size(), Eigen::Vector3d::Zero());
    const Eigen::Vector3d found = best_shift(readings, none, 0.2, turns);
    EXPECT_LT((found - shift).norm(), 1e-4) << turns;
    // Half of it is known already.
    const std::vector<Eigen::Vector3d> half(readings.size(), 0.5 * shift);
    EXPECT_LT((best_shift(readings, half, 0.2, turns) - 0.5 * shift).norm(), 1e-4) << turns;
  }
}

TEST(PhaseModel, WhatIsLeftOfAChannelIsItsOffset) {
  const Eigen::Vector3d shift(0.02, 0.01, -0.05);
  const auto readings = readings_of(shift, 1);
  const std::vector<Eigen::Vector3d> shifts(readings.size(), shift);
  const auto left = turned_back(readings, shifts, 1);
  for (std::size_t i = 0; i < left.size(); ++i) {
    EXPECT_NEAR(std::arg(left[i]), readings[i].channel == 0 ? 0.4 : 2.1, 1e-9);
  }
}

// Abramowitz and Stegun, tables 9.8 and 9.11: I0(1) = 1.266066, I1(1) = 0.565159.
TEST(PhaseModel, TheVonMisesDistributionIsThatOfTables) {
  EXPECT_NEAR(log_von_mises(0.5, 1.0), 0.5 - std::log(2.0 * kPi * 1.266066), 1e-6);
  EXPECT_NEAR(log_von_mises(0.3, 0.0), -std::log(2.0 * kPi), 1e-12);
  EXPECT_NEAR(kappa_of(0.565159 / 1.266066), 1.0, 1e-4);
  EXPECT_EQ(kappa_of(-0.2), 0.0);
  // It sums up to 1, for a sharp one too.
  for (const double kappa : {0.7, 29.0, 45.0}) {
    double sum = 0.0;
    for (int i = 0; i < 3600; ++i) {
      sum += std::exp(log_von_mises(std::cos(radians(0.1 * i)), kappa)) * radians(0.1);
    }
    EXPECT_NEAR(sum, 1.0, 1e-5) << kappa;
  }
}

}  // namespace
}  // namespace mapbed
