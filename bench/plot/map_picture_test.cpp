#include "bench/plot/map_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>

namespace mapbed {
namespace {

// 100 x 40 cells of 10 cm, free, with a wall along the lower edge and one unknown corner.
OccupancyMap hall() {
  OccupancyMap map(0.1);
  for (int x = 0; x < 100; ++x) {
    for (int y = 0; y < 40; ++y) map.at({x, y}) = known(y == 0 ? 1.0 : 0.0);
  }
  map.at({99, 39}) = Occupancy{};
  return map;
}

constexpr int kMargin = 24;  // the map's place in the picture
constexpr int kZoom = 12;    // pixels per cell of so small a map

TEST(MapPicture, ShowsYUpwardsAndUnknownAsNeitherFreeNorOccupied) {
  const RgbImage image = picture_of(hall(), {});
  const auto cell = [&](int x, int y) {
    return image.at(kMargin + x * kZoom + kZoom / 2, kMargin + (39 - y) * kZoom + kZoom / 2);
  };
  EXPECT_EQ(cell(50, 0), kBlack);
  EXPECT_EQ(cell(50, 1), kWhite);
  EXPECT_NE(cell(99, 39), kBlack);
  EXPECT_NE(cell(99, 39), kWhite);
}

TEST(MapPicture, DrawsThePathWhereTheRobotWas) {
  const Trajectory path{{0.0, {1.05, 2.05, 0}}, {1.0, {9.05, 2.05, 0}}};
  const RgbImage with = picture_of(hall(), {{"estimate", path}});
  const RgbImage without = picture_of(hall(), {});
  const int row = kMargin + (39 - 20) * kZoom + kZoom / 2;
  const auto column = [](double meters) {
    return kMargin + static_cast<int>(meters / 0.1 * kZoom);
  };
  EXPECT_NE(with.at(column(5.0), row), without.at(column(5.0), row));
  EXPECT_NE(with.at(column(1.05), row), without.at(column(1.05), row));
  EXPECT_EQ(with.at(column(9.5), row), without.at(column(9.5), row));
  EXPECT_EQ(with.at(column(5.0), row - 5), without.at(column(5.0), row - 5));
}

TEST(MapPicture, ShowsPointsInTheirCellsAndSaysWhatTheyAre) {
  const DrawnPoints points{"met what moves", {{5.04, 2.07}, {500.0, 2.0}}};
  const RgbImage with = picture_of(hall(), {}, {}, points);
  const RgbImage without = picture_of(hall(), {});
  const int x = kMargin + 50 * kZoom, y = kMargin + (39 - 20) * kZoom;
  EXPECT_NE(with.at(x, y), without.at(x, y));
  EXPECT_EQ(with.at(x + kZoom - 1, y + kZoom - 1), with.at(x, y)) << "the whole cell";
  EXPECT_EQ(with.at(x - 1, y), without.at(x - 1, y));
  EXPECT_EQ(with.at(x + kZoom, y), without.at(x + kZoom, y));
}

TEST(MapPicture, DrawsTracksAndWhereNothingWasSeenFaintly) {
  ObjectTrack track{.id = 2};
  for (const double x : {1.05, 3.05, 5.05}) track.states.push_back({.position = {x, 2.05}});
  track.states.back().occluded = true;
  const RgbImage with = picture_of(hall(), {}, {}, {}, {track});
  const int row = kMargin + (39 - 20) * kZoom + kZoom / 2;
  const auto at = [&](double meters) {
    return with.at(kMargin + static_cast<int>(meters / 0.1 * kZoom), row);
  };
  EXPECT_EQ(at(0.5), kWhite);
  EXPECT_LT(at(2.0).red, 100) << "green";
  EXPECT_GT(at(2.0).green, at(2.0).red + 50);
  EXPECT_GT(at(4.0).red, at(2.0).red + 50) << "fainter";
  EXPECT_NE(at(4.0), kWhite);
}

TEST(MapPicture, PointsAreTheEndsOfDynamicBeamsAlone) {
  LaserScan scan;
  scan.max_range = 8.0;
  scan.bearing_step = 0.5;
  scan.ranges = {1.0, 2.0, 8.0};
  const BeamLabels labels{{0.0, 0, {0.1F, 0.9F, 0.1F}}};
  const DrawnPoints drawn = dynamic_points({scan}, {{0.0, {1.0, 2.0, 0.0}}}, labels);
  ASSERT_EQ(drawn.points.size(), 1U);
  EXPECT_NEAR((drawn.points[0] - Eigen::Vector2d(2.0, 2.0)).norm(), 0.0, 1e-12);
  EXPECT_TRUE(dynamic_points({scan}, {{0.0, {}}}, {}).points.empty());
}

TEST(MapPicture, StaysSmallHoweverLargeTheMapAndKeepsThinWalls) {
  OccupancyMap map(0.05);
  for (int x = 0; x < 20000; ++x) map.at({x, 0}) = known(1.0);
  for (int x = 0; x < 20000; ++x) map.at({x, 30}) = known(0.0);
  const RgbImage image = picture_of(map, {}, {.longest_side = 500});
  EXPECT_LE(image.width(), 500 + 2 * kMargin);
  EXPECT_EQ(image.at(kMargin + 250, kMargin), kBlack) << "mean 0.5, maximum 1";
}

TEST(MapPicture, LeavesOutPosesThatAreFarAwayOrNoneAtAll) {
  const double inf = std::numeric_limits<double>::infinity();
  const Trajectory path{{0.0, {1.05, 2.05, 0}}, {1.0, {9.05, 2.05, 0}}};
  Trajectory lost = path;
  for (const double x : {1e9, -1e300, inf, std::nan("")}) lost.push_back({2.0, {x, 2.05, 0}});
  const RgbImage with = picture_of(hall(), {{"estimate", path}});
  const RgbImage image = picture_of(hall(), {{"estimate", lost}});
  const int row = kMargin + (39 - 20) * kZoom + kZoom / 2;
  for (const int x : {kMargin + 300, kMargin + 1000, kMargin + 1150}) {
    EXPECT_EQ(image.at(x, row), with.at(x, row)) << x;
  }
  EXPECT_NE(image, with) << "the legend counts them";
  EXPECT_GT(picture_of(OccupancyMap(0.05), {{"estimate", {{0.0, {1e9, 0, 0}}}}}).width(), 0);
}

TEST(MapPicture, LeavesOutTheFarEndOfABeamThatWentOutOfAWindow) {
  OccupancyMap map = hall();
  for (int x = 100; x < 130; ++x) map.at({x, 20}) = known(0.0);
  const RgbImage image = picture_of(map, {});
  EXPECT_EQ(image.width(), picture_of(hall(), {}).width() + 5 * kZoom) << "0.5 m of it stay";
}

TEST(MapPicture, ShowsTheEndOfACorridorAndWhereverThePathWent) {
  OccupancyMap map = hall();
  for (int x = 100; x < 130; ++x) {
    for (int y = 10; y < 20; ++y) map.at({x, y}) = known(0.0);
  }
  EXPECT_EQ(picture_of(map, {}).width(), picture_of(hall(), {}).width() + 30 * kZoom);
  const Trajectory path{{0.0, {1.05, 2.05, 0}}, {1.0, {11.05, 2.05, 0}}};
  EXPECT_EQ(picture_of(hall(), {{"estimate", path}}).width(),
            picture_of(hall(), {}).width() + 11 * kZoom);
}

TEST(MapPicture, OfAnEmptyMapIsAPictureAllTheSame) {
  const RgbImage image = picture_of(OccupancyMap(0.05), {});
  EXPECT_GT(image.width(), 0);
}

}  // namespace
}  // namespace mapbed
