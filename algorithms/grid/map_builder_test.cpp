#include "algorithms/grid/map_builder.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/grid/testing/drawing.h"
#include "algorithms/scan/beam.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

// One beam forward.
LaserScan scan_of(double range, double time = 0.0) {
  LaserScan scan;
  scan.time = time;
  scan.max_range = 8.0;
  scan.ranges = {range};
  return scan;
}

std::string drawing_after(const LaserScan& scan, const MapOptions& options) {
  return drawing_of(build_map({scan}, {{0.0, Pose2{0.5, 0.5, 0.0}}}, options), {{0, 0}, {9, 0}});
}

TEST(MapBuilder, PutsEachScanAtItsPose) {
  const Trajectory map_from_robot{{0.0, {0.5, 0.5, 0.0}}, {1.0, {0.5, 1.5, 0.0}}};
  const OccupancyMap map =
      build_map({scan_of(3.0, 0.0), scan_of(2.0, 1.0)}, map_from_robot, {.resolution = 1.0});
  EXPECT_EQ(drawing_of(map),
            "..# |"
            "...#|");
}

TEST(MapBuilder, PutsBeamsWhereTheLaserIsMounted) {
  LaserScan scan = scan_of(2.0);
  scan.robot_from_laser.planar = {1.0, 0.0, M_PI / 2};
  const OccupancyMap map = build_map({scan}, {{0.0, Pose2{0.5, 0.5, 0.0}}}, {.resolution = 1.0});
  EXPECT_EQ(drawing_of(map, {{0, 0}, {1, 2}}),
            " #|"
            " .|"
            " .|");
}

TEST(MapBuilder, AMaximumRangeBeamClearsItsPathAndHasNoEnd) {
  EXPECT_EQ(drawing_after(scan_of(8.0), {.resolution = 1.0}), "........  |");
  EXPECT_EQ(drawing_after(scan_of(8.19), {.resolution = 1.0}), "........  |");
  EXPECT_EQ(drawing_after(scan_of(std::numeric_limits<double>::infinity()), {.resolution = 1.0}),
            "........  |");
}

TEST(MapBuilder, OfABeamThatMetSomethingDynamicThePathAloneCounts) {
  const SensorLog log{scan_of(4.0, 0.0), scan_of(4.0, 1.0)};
  const Trajectory path{{0.0, {0.5, 0.5, 0.0}}, {1.0, {0.5, 1.5, 0.0}}};
  const BeamLabels labels{{0.0, 0, {0.9F}}, {1.0, 0, {0.1F}}};
  EXPECT_EQ(drawing_of(build_map(log, path, {.resolution = 1.0}, labels), {{0, 0}, {5, 1}}),
            "....  |"
            "....# |");
}

TEST(MapBuilder, ABeamThatIsLongerThanUsableIsCutThere) {
  EXPECT_EQ(drawing_after(scan_of(5.0), {.resolution = 1.0, .beams = {.usable_range = 3.0}}),
            "...       |");
  EXPECT_EQ(drawing_after(scan_of(2.0), {.resolution = 1.0, .beams = {.usable_range = 3.0}}),
            "..#       |");
}

TEST(MapBuilder, ALaserOfLongRangeSaysNothingWhereNothingCameBack) {
  LaserScan scan = scan_of(81.9);
  scan.max_range = 81.83;
  EXPECT_EQ(drawing_after(scan, {.resolution = 1.0}), "          |");
  EXPECT_EQ(drawing_after(scan, {.resolution = 1.0, .beams = {.no_return_range = 100.0}}),
            "..........|");
  scan.ranges = {60.0};  // was reflected, beyond the usable range
  EXPECT_EQ(drawing_after(scan, {.resolution = 1.0}), "..........|");
}

TEST(MapBuilder, AFailedBeamSaysNothing) {
  for (const double range : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(drawing_after(scan_of(range), {.resolution = 1.0}), "          |");
  }
}

TEST(MapBuilder, KnowsFourModels) {
  EXPECT_EQ(drawing_after(scan_of(3.0), {.model = MapModel::odds, .resolution = 1.0}),
            "...#      |");
  EXPECT_EQ(drawing_after(scan_of(3.0), {.model = MapModel::end_points_odds, .resolution = 1.0}),
            "   #      |");
  EXPECT_EQ(
      drawing_after(scan_of(3.0), {.model = MapModel::end_points_counting, .resolution = 1.0}),
      "   #      |");
}

TEST(MapBuilder, AskedForALogTakesTheScansInIt) {
  const SensorLog log{Odometry{}, scan_of(3.0)};
  const OccupancyMap map = build_map(log, {{0.0, Pose2{0.5, 0.5, 0.0}}}, {.resolution = 1.0});
  EXPECT_EQ(drawing_of(map), "...#|");
}

TEST(MapBuilder, ALongDriveDoesNotHoldItsBoundingBox) {
  // 1 km diagonally at 5 cm: a box of 14142 x 14142 cells, 195,000 tiles; the path alone touches
  // 2 * 707 m / (32 * 0.05 m) = 884 tiles, and beams of 1 m at most the ones beside.
  std::vector<LaserScan> scans;
  Trajectory map_from_robot;
  for (int i = 0; i <= 1000; ++i) {
    scans.push_back(scan_of(1.0, i));
    map_from_robot.push_back({static_cast<double>(i), {i * std::sqrt(0.5), i * std::sqrt(0.5), 0}});
  }
  EXPECT_LT(build_map(scans, map_from_robot).tile_count(), 3U * 884U);
}

TEST(MapBuilder, KnowsTheBoxOfAMapBeforeItIsBuilt) {
  const SensorLog log{scan_of(4.0, 1.0), scan_of(2.0, 2.0)};
  const Trajectory path = {{1.0, {1.02, 0.52, 0.3}}, {2.0, {-1.0, 0.5, 2.0}}};
  const CellBox box = box_of_beams(log, path);
  const CellBox known = known_box(build_map(log, path));
  EXPECT_EQ(box.min, known.min);
  EXPECT_EQ(box.max, known.max);
}

TEST(MapBuilder, RefusesOptionsThatContradictEachOther) {
  EXPECT_INPUT_ERROR(build_map(std::vector<LaserScan>{}, {}, {.resolution = -1.0}),
                     "must be greater than 0");
  EXPECT_INPUT_ERROR(build_map(std::vector<LaserScan>{}, {}, {.resolution = 1e-6}),
                     "choose larger cells or a smaller usable_range");
  EXPECT_INPUT_ERROR(build_map(std::vector<LaserScan>{}, {}, {.odds = {.p_occ = 0.1}}),
                     "0 < p_free < prior < p_occ < 1");
}

TEST(MapBuilder, RefusesAPoseThatNoGridReaches) {
  EXPECT_INPUT_ERROR(build_map({scan_of(1.0)}, {{0.0, Pose2{1e9, 0.0, 0.0}}}),
                     "choose larger cells or move the trajectory");
}

}  // namespace
}  // namespace mapbed
