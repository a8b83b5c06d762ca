#include "algorithms/rfid/antenna_model.h"

#include <cmath>

#include <gtest/gtest.h>

#include "algorithms/rfid/detection_table.h"

namespace mapbed {
namespace {

Eigen::Vector2d at(double distance, double bearing) {
  return {distance * std::cos(bearing), distance * std::sin(bearing)};
}

TEST(PiecewiseAntenna, HasArcDiscAndEverywhereElse) {
  const AntennaModel antenna = PiecewiseAntenna{.direction = radians(10.0),
                                                .opening = radians(90.0),
                                                .range = 5.0,
                                                .disc_radius = 1.0,
                                                .arc_rate = 0.8,
                                                .disc_rate = 0.6,
                                                .elsewhere_rate = 0.05};
  EXPECT_EQ(detection_probability(antenna, at(4.9, radians(10.0))), 0.8);
  EXPECT_EQ(detection_probability(antenna, at(4.9, radians(54.0))), 0.8);
  EXPECT_EQ(detection_probability(antenna, at(4.9, radians(56.0))), 0.05);
  EXPECT_EQ(detection_probability(antenna, at(4.9, radians(-34.0))), 0.8);
  EXPECT_EQ(detection_probability(antenna, at(4.9, radians(-36.0))), 0.05);
  EXPECT_EQ(detection_probability(antenna, at(5.1, radians(10.0))), 0.05);
  EXPECT_EQ(detection_probability(antenna, at(0.9, radians(180.0))), 0.6);
  EXPECT_EQ(detection_probability(antenna, at(1.1, radians(180.0))), 0.05);
}

// Section 7.2: outside of arc and disc a likelihood of 0.5.
TEST(PiecewiseAntenna, WithAllCautionSaysOneHalfWhereNothingIsHeard) {
  PiecewiseAntenna antenna{.arc_rate = 0.8, .elsewhere_rate = 0.0, .caution = 1.0};
  EXPECT_EQ(detection_probability(antenna, at(20.0, 0.0)), 0.5);
  EXPECT_EQ(detection_probability(antenna, at(3.0, 0.0)), 0.9);
}

TEST(HistogramAntenna, TellsTheRateOfACellThatWasLookedIntoOften) {
  HistogramAntenna antenna{.cell_size = 1.0, .cells = 4, .prior_rounds = 1.0};
  antenna.rounds.assign(16, 0.0);
  antenna.detections.assign(16, 0.0);
  antenna.rounds[antenna.index(3, 2)] = 1e6;
  antenna.detections[antenna.index(3, 2)] = 7e5;
  const AntennaModel model = antenna;
  EXPECT_NEAR(detection_probability(model, {1.5, 0.5}), 0.7, 1e-5);
  // The cell behind, as far away, has nothing of its own: as all at its distance.
  EXPECT_NEAR(detection_probability(model, {-1.5, 0.5}), 0.7, 1e-5);
  EXPECT_EQ(detection_probability(model, {2.5, 0.5}), antenna.elsewhere_rate);
}

TEST(SmoothAntenna, IsHalfWayWhereThePowerIsTheThreshold) {
  const SmoothAntenna antenna{.level = 20.0, .falloff = 20.0, .most = 1.0, .least = 0.0};
  // 20 dB over it at 1 m: at it at 10 m ahead; with the 3 dB at half the width at 7.08 m.
  EXPECT_NEAR(detection_probability(antenna, {10.0, 0.0}), 0.5, 1e-12);
  const double to_half = std::pow(10.0, 17.0 / 20.0);
  EXPECT_NEAR(detection_probability(antenna, at(to_half, 0.5 * antenna.beam_width)), 0.5, 1e-12);
  const double behind = std::pow(10.0, 5.0 / 20.0);
  EXPECT_NEAR(detection_probability(antenna, {-behind, 0.0}), 0.5, 1e-12);
}

TEST(SmoothAntenna, ItsAnswersAreWeakerThereAndBack) {
  const SmoothAntenna antenna{.rssi = -40.0, .rssi_falloff = 40.0, .rssi_beam = 2.0};
  EXPECT_NEAR(expected_rssi(antenna, {1.0, 0.0}), -40.0, 1e-12);
  EXPECT_NEAR(expected_rssi(antenna, {10.0, 0.0}), -80.0, 1e-12);
  EXPECT_NEAR(expected_rssi(antenna, at(1.0, 0.5 * antenna.beam_width)), -46.0, 1e-12);
}

TEST(DetectionTable, SaysWhatTheModelSaysInTheMiddlesOfItsCells) {
  HistogramAntenna counted{.cell_size = 0.5, .cells = 8, .prior_rounds = 2.0};
  for (int i = 0; i < 64; ++i) {
    counted.rounds.push_back(10.0);
    counted.detections.push_back(i % 11);
  }
  for (const AntennaModel& antenna :
       {AntennaModel(PiecewiseAntenna{}), AntennaModel(SmoothAntenna{}), AntennaModel(counted)}) {
    const DetectionTable table(antenna);
    for (const Eigen::Vector2d& place : {Eigen::Vector2d(0.55, 0.05), Eigen::Vector2d(3.05, -1.25),
                                         Eigen::Vector2d(-0.75, 1.55)}) {
      const double p = detection_probability(antenna, place);
      const auto x = static_cast<float>(place.x()), y = static_cast<float>(place.y());
      EXPECT_NEAR(table.log_detected(x, y), std::log(p), 1e-5);
      EXPECT_NEAR(table.log_missed(x, y), std::log(1.0 - p), 1e-5);
    }
  }
}

TEST(DetectionTable, IsTheSameEverywhereFarAway) {
  const AntennaModel antenna = PiecewiseAntenna{};
  const DetectionTable table(antenna);
  const double elsewhere = std::log(PiecewiseAntenna{}.elsewhere_rate);
  EXPECT_NEAR(table.log_detected(50.0F, 0.0F), elsewhere, 1e-5);
  EXPECT_NEAR(table.log_detected(-1e30F, 1e30F), elsewhere, 1e-5);
}

TEST(DetectionTable, AnAnswerAsStrongAsExpectedIsMostLikely) {
  const SmoothAntenna antenna;
  const DetectionTable table(antenna);
  const Eigen::Vector2d place(2.05, 0.55);
  const auto usual = static_cast<float>(expected_rssi(antenna, place));
  EXPECT_NEAR(table.log_rssi(2.05F, 0.55F, usual), 0.0, 1e-4);
  const auto off = static_cast<float>(expected_rssi(antenna, place) + antenna.rssi_sigma);
  EXPECT_NEAR(table.log_rssi(2.05F, 0.55F, off), -0.5, 1e-4);
  EXPECT_EQ(DetectionTable(PiecewiseAntenna{}).log_rssi(2.0F, 0.0F, -50.0F), 0.0F);
}

}  // namespace
}  // namespace mapbed
