#include "bench/metrics/pairs.h"

#include <gtest/gtest.h>

namespace mapbed {
namespace {

// There along x in steps of a metre, and back on a line 1 m beside it, looking back.
Trajectory there_and_back(int length) {
  Trajectory path;
  for (int i = 0; i <= length; ++i) path.push_back({1.0 * i, {1.0 * i, 0.0, 0.0}});
  for (int i = length; i >= 0; --i) {
    path.push_back({2.0 * length + 1 - i, {1.0 * i, 1.0, M_PI}});
  }
  return path;
}

TEST(Pairs, AreOfPosesThatAreNearEachOtherAgain) {
  // From the pose at x, 15 - x metres to the end, 1 across and 15 - y back to that at y: at least
  // 28 m where x + y <= 3; those two are within 1.1 m of each other where x = y.
  const std::vector<Relation> pairs = pairs_of(there_and_back(15), {.within = 1.1, .after = 28.0});
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].from_time, 0.0);
  EXPECT_EQ(pairs[0].to_time, 31.0);
  EXPECT_EQ(pairs[1].from_time, 1.0);
  EXPECT_EQ(pairs[1].to_time, 30.0);
  EXPECT_NEAR(pairs[1].from_to.x, 0.0, 1e-12);
  EXPECT_NEAR(pairs[1].from_to.y, 1.0, 1e-12);
  EXPECT_NEAR(pairs[1].from_to.theta, M_PI, 1e-12);
}

TEST(Pairs, AreNoneOnAWayWithoutReturn) {
  Trajectory straight;
  for (int i = 0; i < 100; ++i) straight.push_back({1.0 * i, {1.0 * i, 0.0, 0.0}});
  EXPECT_TRUE(pairs_of(straight).empty());
}

TEST(Pairs, AreFreeOfErrorInTheReferenceItself) {
  const Trajectory reference = there_and_back(30);
  const RelationsError error = relations_error(reference, pairs_of(reference));
  EXPECT_GT(error.count, 10);
  EXPECT_NEAR(error.mean_translation, 0.0, 1e-9);
}

}  // namespace
}  // namespace mapbed
