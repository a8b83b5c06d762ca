#include "algorithms/input/odometry_at_scans.h"

#include <cstdio>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mapbed {
namespace {

using ::testing::ElementsAre;

Measurement odometry(double time, double x, bool motion_unknown = false) {
  return Odometry{
      .time = time, .odometry_from_robot = {x, 0.0, 0.0}, .motion_unknown = motion_unknown};
}
Measurement scan(double time) {
  return LaserScan{.time = time};
}

// "o0.00@0.00 s0.20": what comes out, odometry with its x.
std::vector<std::string> through(std::vector<Measurement> log) {
  OdometryAtScans stage;
  std::vector<std::string> words;
  const auto tell = [&](const std::vector<Measurement>& measurements) {
    for (const Measurement& m : measurements) {
      char word[40];
      if (const auto* reading = std::get_if<Odometry>(&m)) {
        std::snprintf(word, sizeof word, "o%.2f@%.2f", reading->odometry_from_robot.x, time_of(m));
      } else {
        std::snprintf(word, sizeof word, "s%.2f", time_of(m));
      }
      words.emplace_back(word);
    }
  };
  for (Measurement& measurement : log) tell(stage.add(std::move(measurement)));
  tell(stage.finish());
  return words;
}

TEST(OdometryAtScans, IsBetweenTheReadingsBeforeAndAfter) {
  EXPECT_THAT(through({odometry(1.0, 0.0), scan(1.2), odometry(1.5, 1.0)}),
              ElementsAre("o0.00@1.00", "o0.40@1.20", "s1.20", "o1.00@1.50"));
}

TEST(OdometryAtScans, OfScansThatShareTheirStampWithAReadingIsThatReading) {
  EXPECT_THAT(through({odometry(1.0, 0.0), scan(1.0), odometry(2.0, 1.0), scan(2.0)}),
              ElementsAre("o0.00@1.00", "s1.00", "o1.00@2.00", "s2.00"));
  EXPECT_THAT(through({odometry(1.0, 0.0), scan(2.0), odometry(2.0, 1.0)}),
              ElementsAre("o0.00@1.00", "o1.00@2.00", "s2.00"));
}

TEST(OdometryAtScans, OfSeveralScansIsOneForEach) {
  EXPECT_THAT(
      through({odometry(1.0, 0.0), scan(1.2), scan(1.4), odometry(2.0, 1.0)}),
      ElementsAre("o0.00@1.00", "o0.20@1.20", "s1.20", "o0.40@1.40", "s1.40", "o1.00@2.00"));
}

TEST(OdometryAtScans, MayBeFarApartWhereScansAre) {
  EXPECT_THAT(through({odometry(1.0, 0.0), scan(5.0), odometry(6.0, 1.0), scan(10.0), scan(10.1),
                       odometry(11.0, 2.0)}),
              ElementsAre("o0.00@1.00", "o0.80@5.00", "s5.00", "o1.00@6.00", "o1.80@10.00",
                          "s10.00", "o1.82@10.10", "s10.10", "o2.00@11.00"));
}

TEST(OdometryAtScans, IsNotMadeUpWhereItWasOutOrTheMotionIsUnknown) {
  EXPECT_THAT(through({odometry(1.0, 0.0), scan(1.2), scan(2.2), scan(3.2), odometry(3.5, 1.0),
                       scan(4.0), odometry(4.5, 2.0)}),
              ElementsAre("o0.00@1.00", "s1.20", "s2.20", "s3.20", "o1.00@3.50", "o1.50@4.00",
                          "s4.00", "o2.00@4.50"));
  EXPECT_THAT(through({odometry(1.0, 0.0), scan(1.2), odometry(1.5, 1.0, true)}),
              ElementsAre("o0.00@1.00", "s1.20", "o1.00@1.50"));
}

TEST(OdometryAtScans, AreNotWaitedForInALogWithout) {
  OdometryAtScans stage;
  EXPECT_EQ(stage.add(scan(1.0)).size(), 1U);
}

TEST(OdometryAtScans, AreNotWaitedForLong) {
  EXPECT_THAT(through({odometry(1.0, 0.0), scan(1.2), scan(1.6), scan(3.0), scan(3.2)}),
              ElementsAre("o0.00@1.00", "s1.20", "s1.60", "s3.00", "s3.20"));
}

}  // namespace
}  // namespace mapbed
