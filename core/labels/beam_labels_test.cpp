#include "core/labels/beam_labels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mapbed {
namespace {

using ::testing::ElementsAre;

LaserScan scan_of(double time, int laser, std::vector<double> ranges) {
  LaserScan scan;
  scan.time = time;
  scan.laser = laser;
  scan.max_range = 8.0;
  scan.ranges = std::move(ranges);
  return scan;
}

std::vector<double> ranges_of(const Measurement& measurement) {
  return std::get<LaserScan>(measurement).ranges;
}

TEST(BeamLabels, ABeamWithoutLabelIsNotDynamic) {
  EXPECT_FALSE(is_dynamic(kNoLabel));
  EXPECT_FALSE(is_dynamic(0.5F));
  EXPECT_TRUE(is_dynamic(0.49F));
}

TEST(BeamLabels, ThoseOfAFusedScanAreGivenBackToItsLasers) {
  LaserScan both = scan_of(1.0, 0, {1.0, 2.0, 3.0});
  both.parts = {{1.0, 0, 1}, {1.002, 1, 2}};
  const BeamLabels labels{{1.0, 0, {0.1F, 0.2F, 0.3F}}, {2.0, 0, {0.4F}}};
  const BeamLabels apart =
      labels_of_lasers(labels, {both, scan_of(1.5, 2, {4.0}), scan_of(2.0, 0, {5.0})});
  ASSERT_EQ(apart.size(), 3U);
  EXPECT_EQ(apart[0].laser, 0);
  EXPECT_THAT(apart[0].static_probability, ElementsAre(0.1F));
  EXPECT_EQ(apart[1].laser, 1);
  EXPECT_EQ(apart[1].time, 1.002);
  EXPECT_THAT(apart[1].static_probability, ElementsAre(0.2F, 0.3F));
  EXPECT_THAT(apart[2].static_probability, ElementsAre(0.4F));
}

TEST(BeamLabels, ALogWithoutDynamicBeamsHasThemFailed) {
  const SensorLog log{scan_of(1.0, 0, {1.0, 2.0, 8.0}), scan_of(1.0, 1, {3.0}),
                      scan_of(2.0, 0, {4.0})};
  const BeamLabels labels{{1.0, 0, {0.2F, 0.9F, kNoLabel}}, {1.0, 1, {0.0F}}};
  const SensorLog cleaned = without_dynamic_beams(log, labels);
  EXPECT_THAT(ranges_of(cleaned[0]), ElementsAre(0.0, 2.0, 8.0));
  EXPECT_THAT(ranges_of(cleaned[1]), ElementsAre(0.0));
  EXPECT_THAT(ranges_of(cleaned[2]), ElementsAre(4.0)) << "without labels";
}

TEST(BeamLabels, OfAScanThatToldNothingNewSayNothingOfTheRecordedOne) {
  const SensorLog cleaned = without_dynamic_beams({scan_of(1.0, 0, {1.0})}, {{1.0, 0, {}}});
  EXPECT_THAT(ranges_of(cleaned[0]), ElementsAre(1.0));
}

}  // namespace
}  // namespace mapbed
