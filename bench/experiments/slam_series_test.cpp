#include "bench/experiments/slam_series.h"

#include <gmock/gmock.h>

namespace mapbed {
namespace {

// Believes to be where it is told.
class Told : public Estimator {
 public:
  void add(const Measurement& /*measurement*/, std::span<const float> /*weights*/) override {}
  Pose2 pose() const override { return map_from_robot; }
  Estimate estimate() const override { return {}; }
  Hypotheses hypotheses() const override { return held; }

  Pose2 map_from_robot;
  Hypotheses held;
};

// A robot that goes 1 m/s along x from (5, 5), from 100 s to 110 s.
class SlamSeriesOf : public ::testing::Test {
 protected:
  SlamSeriesOf() {
    input_.truth = {{100.0, {5.0, 5.0, 0.0}}, {110.0, {15.0, 5.0, 0.0}}};
    input_.log.push_back(Odometry{.time = 100.0});
    input_.wanted = {"position_error", "effective_number", "distinct_ancestors"};
  }

  RunInput input_;
  Told method_;
};

TEST_F(SlamSeriesOf, ThePositionErrorHasAPointEveryStepAndOneAtTheEnd) {
  SlamSeries series(input_, 4.0);
  for (int second = 0; second <= 10; ++second) {
    // It begins at its own origin and gets 0.1 m a second off to the side.
    method_.map_from_robot = {1.0 * second, 0.1 * second, 0.0};
    series.look(100.0 + second, method_);
  }
  const std::vector<Series> all = series.finish(method_);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].name, "position_error");
  ASSERT_EQ(all[0].points.size(), 3u);  // none where the poses are aligned
  const double times[] = {4.0, 8.0, 10.0};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(all[0].points[i].x, times[i], 1e-9);
    EXPECT_NEAR(all[0].points[i].value, 0.1 * times[i], 1e-9);
  }
}

TEST_F(SlamSeriesOf, WithoutATruePathThereIsNoPositionError) {
  input_.truth.clear();
  SlamSeries series(input_, 4.0);
  series.look(100.0, method_);
  EXPECT_TRUE(series.finish(method_).empty());
}

TEST_F(SlamSeriesOf, ParticlesAreCountedAtUpdates) {
  method_.held.diversity = {{101.0, 1, 9.0, false},
                            {102.0, 2, 8.0, false},
                            {106.0, 3, 7.0, true},
                            {109.0, 10, 6.0, false}};
  input_.wanted = {"effective_number", "distinct_ancestors"};
  SlamSeries series(input_, 4.0);
  const std::vector<Series> all = series.finish(method_);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].name, "effective_number");
  EXPECT_EQ(all[1].name, "distinct_ancestors");
  ASSERT_EQ(all[0].points.size(), 3u);  // 102 s comes before the next point is due
  EXPECT_EQ(all[0].points[0].x, 1.0);
  EXPECT_EQ(all[0].points[1].x, 6.0);
  EXPECT_EQ(all[0].points[2].x, 9.0);
  EXPECT_EQ(all[0].points[1].value, 7.0);
  EXPECT_EQ(all[1].points[2].value, 10.0);
}

TEST_F(SlamSeriesOf, TheLastUpdateIsAPointWhetherOneIsDueOrNot) {
  method_.held.diversity = {{101.0, 1, 9.0, false}, {102.0, 2, 8.0, false}, {103.0, 3, 7.0, false}};
  input_.wanted = {"effective_number"};
  SlamSeries series(input_, 4.0);
  const std::vector<Series> all = series.finish(method_);
  ASSERT_EQ(all.size(), 1u);
  ASSERT_EQ(all[0].points.size(), 2u);
  EXPECT_EQ(all[0].points[1].x, 3.0);
  EXPECT_EQ(all[0].points[1].value, 7.0);
}

TEST_F(SlamSeriesOf, OnlyWhatIsWantedIsGiven) {
  input_.wanted = {"translation_error"};
  method_.held.diversity = {{101.0, 1, 9.0, false}};
  SlamSeries series(input_, 4.0);
  series.look(100.0, method_);
  EXPECT_TRUE(series.finish(method_).empty());
}

TEST_F(SlamSeriesOf, TheLikelihoodOfTheNewestLocalMapIsThereWhereAssociationsAreSearched) {
  Estimate estimate;
  input_.wanted = {"newest_log_likelihood"};
  EXPECT_TRUE(series_of_associations(estimate, input_).empty());
  estimate.associations.emplace();
  estimate.associations->choices = {{104.0, 0, -10.0, -10.0}, {108.0, 1, -22.5, -12.5}};
  const std::vector<Series> all = series_of_associations(estimate, input_);
  ASSERT_EQ(all.size(), 1u);
  ASSERT_EQ(all[0].points.size(), 2u);
  EXPECT_EQ(all[0].points[1].x, 8.0);
  EXPECT_EQ(all[0].points[1].value, -12.5);
  input_.wanted.clear();
  EXPECT_TRUE(series_of_associations(estimate, input_).empty());
}

}  // namespace
}  // namespace mapbed
