#include "algorithms/grid/wall_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/grid/testing/drawing.h"
#include "algorithms/testing/furnished_room.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

struct Drive {
  SensorLog log;
  Trajectory path;
};

Drive drive_in(const TestRoom& room, const std::vector<Eigen::Vector2d>& way,
               const TestLaser& laser) {
  RecordedLog log = drive_through(room, way, {.laser = laser}, Rng(5));
  Drive drive{std::move(log.measurements), {}};
  for (const Measurement& m : drive.log)
    if (const auto* scan = std::get_if<LaserScan>(&m))
      drive.path.push_back({scan->time, *pose_at(log.true_poses, scan->time)});
  return drive;
}

struct Walls {
  int columns = 0;   // steps of one cell along walls that beams came to
  int occupied = 0;  // of them, with an occupied cell on the wall or beside it
  int free = 0;      // cells that the wall goes through which count as free
};

// Of walls of which some cell is known on the very line; a corner belongs to two of them and is
// left out.
Walls walls_in(const OccupancyMap& map, const TestRoom& room) {
  Walls walls;
  for (const Segment& wall : room.walls()) {
    const double length = (wall.b - wall.a).norm();
    const Eigen::Vector2d along = (wall.b - wall.a) / length;
    const Eigen::Vector2d across(-along.y(), along.x());
    for (double s = 0.15; s < length - 0.15; s += map.resolution()) {
      const Eigen::Vector2d point = wall.a + s * along;
      bool known = false;
      bool occupied = false;
      for (const double off : {-1.0, 0.0, 1.0}) {
        const Occupancy& cell = map[map.cell_of(point + off * map.resolution() * across)];
        known = known || cell.known();
        occupied = occupied || cell.probability > 0.65F;
      }
      const Occupancy& on_wall = map[map.cell_of(point)];
      if (!known) continue;
      ++walls.columns;
      walls.occupied += occupied ? 1 : 0;
      walls.free += on_wall.known() && on_wall.probability < 0.196F ? 1 : 0;
    }
  }
  return walls;
}

// Its walls lie in the middle of cells of 5 cm: noise does not reach beyond them.
TestRoom grazing_corridor() {
  return outline({{-0.975, -1.025}, {14.025, -1.025}, {14.025, 1.025}, {-0.975, 1.025}});
}

// With two bodies at its walls; the way below sees all their sides.
TestRoom room_with_bodies() {
  return outline({{-6.025, -4.525},
                  {6.025, -4.525},
                  {6.025, -2.975},
                  {4.025, -2.975},
                  {4.025, -1.025},
                  {6.025, -1.025},
                  {6.025, 4.525},
                  {-2.225, 4.525},
                  {-2.225, 2.625},
                  {-3.775, 2.625},
                  {-3.775, 4.525},
                  {-6.025, 4.525}});
}

struct Case {
  const char* name;
  TestRoom room;
  std::vector<Eigen::Vector2d> way;
  TestLaser laser;
};

std::vector<Case> cases() {
  return {
      {"corridor", grazing_corridor(), {{0, 0}, {12, 0}}, {}},
      {"coarse laser", grazing_corridor(), {{0, 0.3}, {12, 0}}, {91, -kPi / 2, radians(2), 8, {}}},
      {"far laser", grazing_corridor(), {{0, 0}, {12, 0}}, {361, -kPi / 2, radians(0.5), 30, {}}},
      {"room",
       room_with_bodies(),
       {{-5, 3.5}, {-5, 0}, {3, 2}, {0, 3.5}, {0, -3.5}, {3, -3.7}, {5, 0}},
       {360, -kPi, radians(1), 12, {}}}};
}

TEST(WallMap, WallsAreClosedAndNotFreeAtTruePoses) {
  for (const Case& c : cases()) {
    const Drive drive = drive_in(c.room, c.way, c.laser);
    const Walls walls = walls_in(wall_map(drive.log, drive.path), c.room);
    ASSERT_GT(walls.columns, 100) << c.name;
    EXPECT_GE(walls.occupied, 0.99 * walls.columns) << c.name;
    EXPECT_EQ(walls.free, 0) << c.name;
  }
}

TEST(WallMap, WallsAreClosedAtPosesThatAreACentimetreOff) {
  for (const Case& c : cases()) {
    Drive drive = drive_in(c.room, c.way, c.laser);
    Rng rng(7);
    for (auto& [time, pose] : drive.path)
      pose =
          pose * Pose2{rng.normal(0.0, 0.01), rng.normal(0.0, 0.01), rng.normal(0.0, radians(0.2))};
    const Walls walls = walls_in(wall_map(drive.log, drive.path), c.room);
    EXPECT_GE(walls.occupied, 0.99 * walls.columns) << c.name;
  }
}

// One beam every metre of the wall, and through each of the wall's cells others go.
TEST(WallMap, AFractionOfBeamsLeavesHolesInAGrazingWallWhereThisDoesNot) {
  const Drive drive = drive_in(grazing_corridor(), {{0, 0}, {12, 0}}, {});
  const Walls counted = walls_in(build_map(drive.log, drive.path), grazing_corridor());
  EXPECT_LT(counted.occupied, 0.9 * counted.columns);
}

TEST(WallMap, ABeamWithoutReturnEndsAtAWallThatOthersSaw) {
  // A wall at x = 4, of which one beam in eight gets no return.
  Drive drive =
      drive_in(outline({{-2, -3}, {4.025, -3}, {4.025, 3}, {-2, 3}}), {{0, 0}, {1, 0}}, {});
  int n = 0;
  for (Measurement& m : drive.log) {
    auto* scan = std::get_if<LaserScan>(&m);
    if (scan == nullptr) continue;
    for (double& r : scan->ranges)
      if (++n % 8 == 0) r = scan->max_range;
  }
  const OccupancyMap map = wall_map(drive.log, drive.path);
  const CellBox behind{map.cell_of({4.2, -2}), map.cell_of({8, 2})};
  int free = 0;
  map.for_each_in(behind, [&](CellIndex, const Occupancy& cell) { free += cell.known() ? 1 : 0; });
  EXPECT_EQ(free, 0);
}

TEST(WallMap, ABeamWithoutReturnClearsItsPathWhereNothingIs) {
  LaserScan scan;
  scan.max_range = 8.0;
  scan.ranges = {8.0};
  const OccupancyMap map = wall_map({scan}, {{0.0, {0.5, 0.5, 0.0}}}, {.resolution = 1.0});
  EXPECT_EQ(drawing_of(map), "........|");
}

// Half a metre of somebody who stood there in one scan of ten.
TEST(WallMap, WhatWasThereForAWhileIsFree) {
  SensorLog log;
  Trajectory path;
  for (int i = 0; i < 30; ++i) {
    LaserScan scan;
    scan.time = i;
    scan.max_range = 8.0;
    scan.ranges = {i % 10 == 0 ? 3.2 : 6.2};
    log.emplace_back(scan);
    path.push_back({scan.time, {0.5, 0.5, 0.0}});
  }
  EXPECT_EQ(drawing_of(wall_map(log, path, {.resolution = 1.0}), {{0, 0}, {8, 0}}), "......#  |");
}

TEST(WallMap, ADoorwayStaysOpen) {
  TestRoom room({{{3.025, -3.0}, {3.025, -0.4}},
                 {{3.025, 0.4}, {3.025, 3.0}},
                 {{6.025, -3.0}, {6.025, 3.0}}});
  const Drive drive = drive_in(room, {{0, -1}, {0.5, 1}}, {361, -kPi / 2, radians(0.5), 8, {}});
  const OccupancyMap map = wall_map(drive.log, drive.path);
  for (double y = -0.3; y <= 0.3; y += 0.05)
    EXPECT_EQ(map[map.cell_of({3.025, y})].probability, 0.0F) << y;
}

TEST(WallMap, WhatADynamicBeamMetIsNoWallAndItsPathIsFree) {
  LaserScan scan;
  scan.max_range = 8.0;
  scan.ranges = {5.0};
  const Trajectory path{{0.0, {0.5, 0.5, 0.0}}};
  const BeamLabels of_place{{0.0, 0, {0.9F}}}, dynamic{{0.0, 0, {0.1F}}};
  const MapOptions options{.resolution = 1.0};
  const CellBox row{{0, 0}, {8, 0}};
  EXPECT_EQ(drawing_of(wall_map({scan}, path, options, of_place), row), ".....#   |");
  EXPECT_EQ(drawing_of(wall_map({scan}, path, options, dynamic), row), ".....    |");
}

}  // namespace
}  // namespace mapbed
