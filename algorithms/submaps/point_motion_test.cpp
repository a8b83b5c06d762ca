#include "algorithms/submaps/point_motion.h"

#include <gtest/gtest.h>

namespace mapbed {
namespace {

TEST(PointMotion, MovesPointsAsItsPoseDoesToTheLastBit) {
  for (const Pose2& pose : {Pose2{}, Pose2{1.1, -2.3, 0.7}, Pose2{-100.3, 0.01, 3.1}}) {
    for (const Eigen::Vector2d& point : {Eigen::Vector2d(0.1, 0.2), Eigen::Vector2d(-31.7, 12.9)}) {
      EXPECT_EQ(PointMotion(pose) * point, pose * point);
    }
  }
  EXPECT_EQ(PointMotion() * Eigen::Vector2d(1.0, 2.0), Eigen::Vector2d(1.0, 2.0));
}

}  // namespace
}  // namespace mapbed
