#include "algorithms/filtered_estimator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

LaserScan scan_at(double time, std::size_t beams, double pitch = 0.0) {
  LaserScan scan;
  scan.time = time;
  scan.max_range = 8.0;
  scan.ranges.assign(beams, 1.0);
  scan.robot_from_laser.pitch = pitch;
  return scan;
}

// Remembers what it was given.
struct WhatWasGiven {
  std::vector<std::vector<float>> weights;
  int readings = 0;
};

class FakeMethod : public Estimator {
 public:
  explicit FakeMethod(WhatWasGiven& given) : given_(given) {}
  void add(const Measurement& measurement, std::span<const float> beam_weights) override {
    if (std::holds_alternative<Odometry>(measurement)) ++given_.readings;
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr) return;
    given_.weights.emplace_back(beam_weights.begin(), beam_weights.end());
    if (scan->robot_from_laser.is_level()) path_.push_back({scan->time, {scan->time, 0.0, 0.0}});
  }
  Pose2 pose() const override { return path_.back().pose; }
  Estimate estimate() const override {
    return {.trajectory = path_, .remarks = {{RemarkKind::note, "of the method"}}};
  }

 private:
  WhatWasGiven& given_;
  Trajectory path_;
};

// Believes nothing of each scan's first beam.
class FakeFilter : public BeamFilter {
 public:
  explicit FakeFilter(int& readings) : readings_(readings) {}
  void add(const Odometry&) override { ++readings_; }
  std::vector<float> add(const LaserScan& scan, std::span<const float>) override {
    std::vector<float> weights(scan.ranges.size(), 0.5F);
    weights.front() = 0.0F;
    labels_.push_back({scan.time, scan.laser, weights});
    return weights;
  }
  FilterResult result(const Trajectory& map_from_robot) const override {
    ObjectTrack track;
    for (const Stamped<Pose2>& stamped : map_from_robot) {
      TrackState state;
      state.time = stamped.time;
      state.position = stamped.pose.position();
      track.states.push_back(state);
    }
    return {labels_, Tracks{track}, {{RemarkKind::note, "of the filter"}}};
  }

 private:
  int& readings_;
  BeamLabels labels_;
};

class Filtered : public ::testing::Test {
 protected:
  WhatWasGiven given_;
  int readings_ = 0;
  FilteredEstimator estimator_{std::make_unique<FakeMethod>(given_),
                               std::make_unique<FakeFilter>(readings_)};
};

TEST_F(Filtered, TheMethodGetsTheWeightsOfTheFilterTimesThoseThatWereTold) {
  estimator_.add(scan_at(1.0, 3));
  estimator_.add(scan_at(2.0, 3), std::vector<float>{1.0F, 1.0F, 0.5F});
  EXPECT_THAT(given_.weights,
              ElementsAre(ElementsAre(0.0F, 0.5F, 0.5F), ElementsAre(0.0F, 0.5F, 0.25F)));
}

TEST_F(Filtered, BothGetOdometry) {
  estimator_.add(Odometry{});
  EXPECT_EQ(given_.readings, 1);
  EXPECT_EQ(readings_, 1);
}

TEST_F(Filtered, AScanOfATiltedLaserPassesByTheFilter) {
  estimator_.add(scan_at(1.0, 2, 0.3));
  estimator_.add(scan_at(2.0, 2));
  EXPECT_THAT(given_.weights, ElementsAre(IsEmpty(), ElementsAre(0.0F, 0.5F)));
  EXPECT_EQ(estimator_.estimate().labels->size(), 1U);
}

TEST_F(Filtered, TheEstimateHasLabelsTracksAndTheRemarksOfBoth) {
  estimator_.add(scan_at(1.0, 2));
  estimator_.add(scan_at(2.0, 2));
  const Estimate estimate = estimator_.estimate();
  ASSERT_TRUE(estimate.labels.has_value());
  EXPECT_TRUE(is_dynamic(estimate.labels->at(1), 0));
  ASSERT_TRUE(estimate.tracks.has_value());
  EXPECT_EQ(estimate.tracks->at(0).states.at(1).position.x(), 2.0);
  ASSERT_EQ(estimate.remarks.size(), 2U);
  EXPECT_EQ(estimate.remarks[1].text, "of the filter");
}

}  // namespace
}  // namespace mapbed
