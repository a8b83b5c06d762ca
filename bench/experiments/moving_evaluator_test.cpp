#include "bench/experiments/moving_evaluator.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

namespace mapbed {
namespace {

// Four looks of one beam along a row of cells of 1 m: one ends in the fourth cell, which is of the
// world, as glass may send a beam back, the others in the eighth.
class ARowWithGlass : public ::testing::Test {
 protected:
  ARowWithGlass()
      : truth_{.resolution = 1.0, .width = 10, .height = 1}, map_(GridFrame{.resolution = 1.0}) {
    truth_.cells.assign(10, TrueCell::free);
    truth_.cells[3] = truth_.cells[7] = TrueCell::occupied;
    for (int i = 0; i < 4; ++i) {
      LaserScan scan;
      scan.time = i;
      scan.max_range = 20.0;
      scan.ranges = {i == 0 ? 3.0 : 7.0};
      input_.log.emplace_back(scan);
      estimate_.trajectory.push_back({scan.time, {0.5, 0.5, 0.0}});
    }
    input_.true_map = [this](double) -> const TrueMap& { return truth_; };
    for (const Metric& metric : moving_metrics()) input_.wanted.insert(metric.name);
  }

  // With such labels of the four.
  std::map<std::string, double> values(const std::vector<float>& of_beams) {
    estimate_.labels.emplace();
    for (std::size_t i = 0; i < of_beams.size(); ++i) {
      estimate_.labels->push_back({static_cast<double>(i), 0, {of_beams[i]}});
    }
    const MapOptions options{.resolution = 1.0};
    map_ = build_map(input_.log, estimate_.trajectory, options, *estimate_.labels);
    MovingEvaluator evaluator({}, options, input_, estimate_, estimate_.trajectory, map_);
    const auto pairs = evaluator.values();
    return {pairs.begin(), pairs.end()};
  }

  TrueMap truth_;
  RunInput input_;
  Estimate estimate_;
  OccupancyMap map_;
};

TEST_F(ARowWithGlass, IsLostToThoseWhoAreToldThatItIsFree) {
  EXPECT_EQ(values({0.9F, 0.9F, 0.9F, 0.9F})["lost_cells"], 0.0);
  EXPECT_EQ(values({0.1F, 0.9F, 0.9F, 0.9F})["lost_cells"], 0.5) << "one of two";
}

TEST_F(ARowWithGlass, BeamsCalledDynamicAreAFractionOfThoseWithALabel) {
  EXPECT_EQ(values({0.1F, 0.9F, kNoLabel, kNoLabel})["called_dynamic"], 0.5);
  EXPECT_TRUE(std::isnan(values({kNoLabel, kNoLabel, kNoLabel, kNoLabel})["called_dynamic"]));
}

}  // namespace
}  // namespace mapbed
