#include "algorithms/field/local_map.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/random.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;

std::vector<Pose2> drive(int scans, double step) {
  std::vector<Pose2> poses;
  for (int i = 0; i < scans; ++i) poses.push_back({i * step, 0.0, 0.0});
  return poses;
}

TEST(LocalMap, TakesTheNewestScanAndThenOneForEveryMinDistanceBack) {
  const LocalMapOptions options{
      .max_scans = 3, .max_history = 100, .min_distance = 0.25, .min_turn = 9};
  EXPECT_THAT(select_local_scans(drive(10, 0.1), options), ElementsAre(9, 6, 3));
}

TEST(LocalMap, LooksBackNoFartherThanItsHistory) {
  // t = 10 is the scan to be matched; t - i < 5 leaves i > 5.
  const LocalMapOptions options{
      .max_scans = 9, .max_history = 5, .min_distance = 0.15, .min_turn = 9};
  EXPECT_THAT(select_local_scans(drive(10, 0.1), options), ElementsAre(9, 7));
}

TEST(LocalMap, TakesScansThatWereTurnedOnTheSpot) {
  const LocalMapOptions options{
      .max_scans = 9, .max_history = 100, .min_distance = 1, .min_turn = 0.5};
  EXPECT_THAT(select_local_scans({{0, 0, 0}, {0, 0, 0.3}, {0, 0, 0.6}}, options),
              ElementsAre(2, 0));
}

TEST(LocalMap, MeasuresTurnsTheShortWayRound) {
  const LocalMapOptions options{
      .max_scans = 9, .max_history = 100, .min_distance = 1, .min_turn = 0.5};
  EXPECT_THAT(select_local_scans({{0, 0, 3.1}, {0, 0, -3.1}}, options), ElementsAre(1));
}

TEST(LocalMap, OfNoScansIsEmpty) {
  EXPECT_TRUE(select_local_scans({}, {}).empty());
}

TEST(SurfaceMeans, KeepOneMeanForEveryCellThatWasHit) {
  SurfaceMeans means(0.1);
  means.add({{{0.02, 0.04}}, {{0.04, 0.02}}, {{0.55, -0.35}}});
  ASSERT_EQ(means.means().size(), 2U);
  EXPECT_LT((means.means()[0].position - Eigen::Vector2d(0.03, 0.03)).norm(), 6e-8);  // a step
  means.clear();
  EXPECT_TRUE(means.means().empty());
}

TEST(SurfacePoint, DirectionsAverageAcrossTheWrap) {
  // 170 and -170 degrees are nearly one line, along x.
  const auto doubled = [](double a) { return Eigen::Vector2d(std::cos(2 * a), std::sin(2 * a)); };
  const Eigen::Vector2d mean = 0.5 * (doubled(radians(170)) + doubled(radians(-170)));
  EXPECT_LT((tangent_of(mean).cwiseAbs() - Eigen::Vector2d(1.0, 0.0)).norm(), 1e-12);
  EXPECT_TRUE(tangent_of(0.5 * (doubled(0.0) + doubled(kPi / 2))).isZero());
}

TEST(SurfacePoint, TurnsWithItsFrame) {
  const SurfacePoint along_x{{1.0, 0.0}, {1.0, 0.0}};
  const SurfacePoint turned = transformed(std::vector{along_x}, Pose2{0, 0, kPi / 3})[0];
  EXPECT_LT((tangent_of(turned.doubled) - Eigen::Vector2d(0.5, std::sqrt(0.75))).norm(), 1e-12);
}

TEST(SurfaceMeans, ForgetExactlyWhatIsTakenOut) {
  Rng rng(4);
  const auto some_points = [&] {
    std::vector<SurfacePoint> points(50);
    for (SurfacePoint& point : points) {
      point = {{rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3)}, {rng.uniform(-1, 1), 0.3}};
    }
    return points;
  };
  const std::vector<SurfacePoint> first = some_points(), second = some_points();
  SurfaceMeans all(0.05), second_alone(0.05);
  all.add(first);
  all.add(second);
  all.remove(first);
  second_alone.add(second);
  EXPECT_EQ(all.means().size(), second_alone.means().size());
  for (int y = -8; y <= 8; ++y) {
    for (int x = -8; x <= 8; ++x) {
      const auto mean = all.mean_in({x, y}), expected = second_alone.mean_in({x, y});
      ASSERT_EQ(mean.has_value(), expected.has_value());
      if (!mean) continue;
      EXPECT_EQ(mean->position, expected->position);
      EXPECT_EQ(mean->doubled, expected->doubled);
    }
  }
}

}  // namespace
}  // namespace mapbed
