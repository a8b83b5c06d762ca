#include "algorithms/localization/free_space.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

using ::testing::Optional;

// Cells of 1 m: a wall, free, unknown, free; and what is as likely free as not.
std::shared_ptr<const OccupancyMap> row() {
  OccupancyMap map(1.0);
  map.at({0, 0}) = known(1.0);
  map.at({1, 0}) = known(0.1);
  map.at({3, 0}) = known(0.0);
  map.at({4, 0}) = known(0.5);
  return std::make_shared<OccupancyMap>(map);
}

TEST(FreeSpace, IsWhatIsKnownToBeFree) {
  const FreeSpace space(row());
  EXPECT_EQ(space.area(), 2.0);
  EXPECT_TRUE(space.contains({1.5, 0.5}));
  EXPECT_FALSE(space.contains({0.5, 0.5}));
  EXPECT_FALSE(space.contains({2.5, 0.5}));
  EXPECT_FALSE(space.contains({4.5, 0.5}));
  EXPECT_TRUE(FreeSpace(std::make_shared<OccupancyMap>(1.0)).empty());
}

TEST(FreeSpace, PosesAreDrawnUniformlyInPlaceAndHeading) {
  const FreeSpace space(row());
  constexpr int n = 20'000;
  Rng rng(1);
  int right = 0, ahead = 0;
  double x = 0.0;
  for (int i = 0; i < n; ++i) {
    const Pose2 pose = space.sample(rng);
    ASSERT_TRUE(space.contains(pose.position()));
    right += pose.x > 2.0 ? 1 : 0;
    ahead += std::abs(pose.theta) < kPi / 2 ? 1 : 0;
    x += pose.x > 2.0 ? pose.x - 3.0 : pose.x - 1.0;
  }
  const double five_sigma = 5.0 * std::sqrt(0.25 / n);
  EXPECT_NEAR(static_cast<double>(right) / n, 0.5, five_sigma);
  EXPECT_NEAR(static_cast<double>(ahead) / n, 0.5, five_sigma);
  EXPECT_NEAR(x / n, 0.5, 5.0 / std::sqrt(12.0 * n));
}

TEST(FreeSpace, NearAPathIsWhatIsWithinADistanceOfIt) {
  const std::vector<Pose2> path{{3.6, 0.5, 0.0}};
  const FreeSpace near = FreeSpace(row()).near(path, 1.0);
  EXPECT_EQ(near.area(), 1.0);
  Rng rng(1);
  EXPECT_GT(near.sample(rng).x, 3.0);
  EXPECT_EQ(FreeSpace(row()).near(path, 2.2).area(), 2.0);
}

TEST(FreeSpace, SaysWhatIsWrongWithAPlace) {
  EXPECT_FALSE(trouble_at(*row(), {1.5, 0.5}));
  EXPECT_THAT(trouble_at(*row(), {0.5, 0.5}), Optional(std::string("in a wall")));
  EXPECT_THAT(trouble_at(*row(), {2.5, 0.5}), Optional(std::string("where nothing is known")));
  EXPECT_THAT(trouble_at(*row(), {9.5, 0.5}), Optional(std::string("outside the map")));
}

}  // namespace
}  // namespace mapbed
