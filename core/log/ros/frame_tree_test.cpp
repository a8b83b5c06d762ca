#include "core/log/ros/frame_tree.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/pose2.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;

Stamped<Pose3> at(double x, double y, double theta = 0.0, double time = 0.0) {
  return {time, upright(Pose2{x, y, theta})};
}

TEST(FrameTree, AMountGoesByTheNearestFrameThatBothHangOn) {
  FrameTree tree;
  EXPECT_TRUE(tree.add("odom", "base", at(100.0, 0.0)));
  EXPECT_TRUE(tree.add("base", "footprint", at(0.0, -1.0)));
  EXPECT_TRUE(tree.add("base", "mast", at(2.0, 0.0)));
  EXPECT_TRUE(tree.add("mast", "laser", at(0.5, 0.0)));
  const auto mount = tree.mount("footprint", "laser");
  ASSERT_TRUE(mount);
  EXPECT_TRUE(mount->base_from_frame.position.isApprox(Eigen::Vector3d(2.5, 1.0, 0.0)));
  EXPECT_EQ(mount->moving, "");
  EXPECT_FALSE(tree.mount("base", "camera"));
  EXPECT_TRUE(tree.mount("base", "base"));
}

TEST(FrameTree, AFrameThatMovesOnTheWayIsNamed) {
  FrameTree tree;
  tree.add("odom", "base", at(0.0, 0.0));
  tree.add("odom", "base", at(5.0, 0.0));
  tree.add("base", "head", at(0.0, 0.0, 0.0));
  tree.add("head", "laser", at(1.0, 0.0));
  tree.add("base", "head", at(0.0, 0.0, 0.5));
  EXPECT_EQ(tree.mount("base", "laser")->moving, "head");
  EXPECT_EQ(tree.mount("base", "laser")->base_from_frame.position.x(), 1.0) << "by the first pose";
}

TEST(FrameTree, TakesNoPoseThatIsNoneAndNoSecondParent) {
  FrameTree tree;
  EXPECT_TRUE(tree.add("base", "laser", at(1.0, 0.0)));
  EXPECT_FALSE(tree.add("odom", "laser", at(1.0, 0.0)));
  EXPECT_FALSE(tree.add("base", "laser", at(NAN, 0.0)));
  EXPECT_FALSE(tree.add("base", "base", at(1.0, 0.0)));
  EXPECT_FALSE(tree.add("", "camera", at(1.0, 0.0)));
  Stamped<Pose3> no_turn = at(1.0, 0.0);
  no_turn.pose.rotation.coeffs().setZero();
  EXPECT_FALSE(tree.add("base", "camera", no_turn));
}

TEST(FrameTree, ARingOfFramesHasAnEnd) {
  FrameTree tree;
  tree.add("a", "b", at(1.0, 0.0));
  tree.add("b", "c", at(1.0, 0.0));
  tree.add("c", "a", at(1.0, 0.0));
  EXPECT_FALSE(tree.mount("elsewhere", "a"));
  EXPECT_TRUE(tree.mount("b", "a"));
}

TEST(FrameTree, KnowsWhatHangsOnAFrame) {
  FrameTree tree;
  tree.add("odom", "base_link", at(1.0, 0.0));
  tree.add("odom", "a", at(1.0, 0.0));
  EXPECT_THAT(tree.children_of("odom"), ElementsAre("a", "base_link"));
  EXPECT_TRUE(tree.knows("odom"));
  EXPECT_FALSE(tree.knows("map"));
}

}  // namespace
}  // namespace mapbed
