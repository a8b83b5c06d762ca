#include "algorithms/scan/level_lasers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/testing/remark_texts.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

LaserScan scan_of_laser(int laser, double pitch, double roll = 0.0) {
  return {.laser = laser, .robot_from_laser = {.pitch = pitch, .roll = roll}};
}

TEST(LevelLasers, TakeAllScansOfLevelLasers) {
  LevelLasers lasers;
  EXPECT_TRUE(lasers.take(scan_of_laser(0, 0.0)));
  EXPECT_TRUE(lasers.take(scan_of_laser(1, 0.0)));
  EXPECT_THAT(texts_of(lasers.remarks()), IsEmpty());
}

TEST(LevelLasers, LeaveATiltedOneOutAndSaySoOnce) {
  LevelLasers lasers;
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(lasers.take(scan_of_laser(1, radians(10.0))));
    EXPECT_FALSE(lasers.take(scan_of_laser(2, 0.0, radians(-90.0))));
  }
  EXPECT_THAT(texts_of(lasers.remarks()),
              ElementsAre(HasSubstr("laser 1 is tilted by 10 degrees: left out"),
                          HasSubstr("laser 2 is tilted by 90 degrees")));
}

}  // namespace
}  // namespace mapbed
