#include "algorithms/dynamic_em/dynamic_em.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/scan_matching/incremental_matcher.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

using ::testing::SizeIs;

DynamicEm em_of(const DynamicEmOptions& options = {}) {
  return {options, [] { return std::unique_ptr<Estimator>(new IncrementalMatcher()); }};
}

// A robot drives there and back past a box that is there in the first quarter of the time alone.
SensorLog drive_past_a_box() {
  TestRoom room = rectangular_room(7.0, 5.0);
  room.add_box({-2.6, 1.8}, 0.6, 0.5);
  RecordedLog empty = drive_through(room, {{-2.0, 0.0}, {2.0, 0.3}, {-2.0, 0.0}}, {}, Rng(1));
  room.add_box({0.5, -1.2}, 0.4, 0.4);
  RecordedLog full = drive_through(room, {{-2.0, 0.0}, {2.0, 0.3}, {-2.0, 0.0}}, {}, Rng(1));
  const double quarter =
      0.25 * time_of(empty.measurements.back()) + 0.75 * time_of(empty.measurements.front());
  SensorLog log;
  for (std::size_t i = 0; i < empty.measurements.size(); ++i) {
    const Measurement& m = full.measurements[i];
    log.push_back(time_of(m) < quarter ? m : empty.measurements[i]);
  }
  return log;
}

TEST(DynamicEm, LabelsEveryScanAndTellsItsLikelihoods) {
  DynamicEm em = em_of();
  for (const Measurement& m : drive_past_a_box()) em.add(m);
  em.finish();
  const Estimate estimate = em.estimate();
  ASSERT_TRUE(estimate.labels.has_value());
  EXPECT_THAT(*estimate.labels, SizeIs(estimate.trajectory.size()));
  ASSERT_THAT(estimate.iterations, SizeIs(2));
  EXPECT_EQ(estimate.iterations[1].name, "marginal_log_likelihood");
  EXPECT_GE(estimate.iterations[1].values.size(), 2U);
  ASSERT_FALSE(estimate.remarks.empty());
  EXPECT_THAT(estimate.remarks.back().text, ::testing::StartsWith("EM: "));
}

TEST(DynamicEm, KeepsTheIterationOfTheLargestMarginalLikelihood) {
  DynamicEm em = em_of({.iterations = 6, .improvement = 0.0});
  for (const Measurement& m : drive_past_a_box()) em.add(m);
  em.finish();
  const Estimate estimate = em.estimate();
  const std::vector<double>& marginal = estimate.iterations[1].values;
  CauseMap map(drive_past_a_box(), estimate.trajectory, {});
  for (int i = 0; i < DynamicEmOptions{}.map_steps; ++i) map.step();
  EXPECT_NEAR(map.marginal_log_likelihood(), *std::max_element(marginal.begin(), marginal.end()),
              1e-6 * std::abs(marginal.front()));
}

TEST(DynamicEm, WithoutRegistrationThePathIsThatOfTheMethodAndTheLikelihoodNeverFalls) {
  DynamicEm em = em_of({.iterations = 5, .register_again = false, .improvement = 0.0});
  IncrementalMatcher alone;
  for (const Measurement& m : drive_past_a_box()) {
    em.add(m);
    alone.add(m);
  }
  em.finish();
  const Estimate estimate = em.estimate();
  const Trajectory expected = alone.estimate().trajectory;
  ASSERT_EQ(estimate.trajectory.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(estimate.trajectory[i].pose, expected[i].pose);
  }
  const std::vector<double>& marginal = estimate.iterations[1].values;
  for (std::size_t i = 1; i < marginal.size(); ++i) EXPECT_GE(marginal[i], marginal[i - 1] - 1e-3);
}

// Takes down how its beams are weighed.
class WeightsTaken : public Estimator {
 public:
  explicit WeightsTaken(std::vector<std::vector<float>>& weights) : weights_(weights) {
    weights_.clear();
  }
  void add(const Measurement& m, std::span<const float> weights) override {
    weights_.emplace_back(weights.begin(), weights.end());
    path_.push_back({time_of(m), {0.5, 0.5, 0.0}});
  }
  Pose2 pose() const override { return {0.5, 0.5, 0.0}; }
  Estimate estimate() const override { return {.trajectory = path_}; }

 private:
  std::vector<std::vector<float>>& weights_;
  Trajectory path_;
};

LaserScan beam_at(double time, double range) {
  LaserScan scan;
  scan.time = time;
  scan.max_range = 20.0;
  scan.ranges = {range};
  return scan;
}

TEST(DynamicEm, RegistersAgainWithoutDynamicBeamsAndWithWhatItWasTold) {
  std::vector<std::vector<float>> weights;
  DynamicEm em({.iterations = 2, .improvement = 0.0, .resolution = 1.0},
               [&] { return std::unique_ptr<Estimator>(new WeightsTaken(weights)); });
  em.add(beam_at(0.0, 3.0));
  for (int i = 1; i < 30; ++i) em.add(beam_at(i, 7.0), std::vector<float>{0.5F});
  em.finish();
  ASSERT_THAT(weights, SizeIs(30));
  EXPECT_EQ(weights[0][0], 0.0F) << "29 beams passed where it ended";
  EXPECT_NEAR(weights[1][0], 0.5F, 0.01) << "static, as it was told";
}

TEST(DynamicEm, OfNothingIsNothing) {
  DynamicEm em = em_of();
  em.finish();
  EXPECT_TRUE(em.estimate().trajectory.empty());
}

}  // namespace
}  // namespace mapbed
