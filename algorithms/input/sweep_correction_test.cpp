#include "algorithms/input/sweep_correction.h"

#include <gtest/gtest.h>

#include "algorithms/scan/hit_points.h"
#include "core/geometry/angle.h"
#include "core/testing/is_near.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

// A sweep over the whole room in 0.2 s, each beam from where the robot is by then.
LaserScan sweep_of(const TestRoom& room, const Trajectory& path, double time, double period,
                   const Pose2& mount) {
  const TestLaser laser{.beams = 360,
                        .first_bearing = -kPi,
                        .bearing_step = radians(1.0),
                        .max_range = 20.0,
                        .robot_from_laser = mount};
  LaserScan scan = scan_of(room, *pose_at(path, time), laser, time);
  scan.beam_period = period;
  for (std::size_t beam = 0; beam < 360; ++beam) {
    const std::size_t place = period > 0.0 ? beam : 359 - beam;
    const double taken = time + static_cast<double>(place) * std::abs(period);
    scan.ranges[beam] = scan_of(room, *pose_at(path, taken), laser).ranges[beam];
  }
  return scan;
}

// From the walls of a room of 6 m x 4 m, at worst [m].
double farthest_off_the_walls(const LaserScan& scan, const Pose2& room_from_robot) {
  double farthest = 0.0;
  for (const Eigen::Vector2d& hit : all_hit_points(scan, 20.0)) {
    const Eigen::Vector2d p = room_from_robot * hit;
    farthest = std::max(farthest,
                        std::min(std::abs(3.0 - std::abs(p.x())), std::abs(2.0 - std::abs(p.y()))));
  }
  return farthest;
}

class CorrectedSweep : public ::testing::TestWithParam<Pose2> {};

TEST_P(CorrectedSweep, LiesOnTheWallsThatItSaw) {
  Trajectory path;
  for (int i = 0; i <= 10; ++i) {
    path.push_back({0.1 * i, Pose2{0.5, -0.3, 0.4} * interpolate({}, GetParam(), 0.1 * i)});
  }
  for (const double period : {0.2 / 360.0, -0.2 / 360.0}) {
    const LaserScan scan =
        sweep_of(rectangular_room(6.0, 4.0), path, 0.3, period, {0.1, 0.05, 0.3});
    const Pose2 at_stamp = *pose_at(path, 0.3);
    EXPECT_GT(farthest_off_the_walls(scan, at_stamp), 0.05);
    EXPECT_LT(farthest_off_the_walls(with_corrected_sweep(scan, path), at_stamp), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Motions, CorrectedSweep,
                         ::testing::Values(Pose2{0.0, 0.0, 1.5}, Pose2{1.0, 0.0, 0.0},
                                           Pose2{0.8, 0.0, -1.0}, Pose2{0.0, -0.7, 2.5}));

TEST(SweepCorrection, LeavesScansOfARobotThatStandsAsTheyAre) {
  const Trajectory path{{0.0, {}}, {1.0, {}}};
  const LaserScan scan = sweep_of(rectangular_room(6.0, 4.0), path, 0.3, 0.2 / 360.0, {});
  EXPECT_TRUE(with_corrected_sweep(scan, path).robot_from_beams.empty());
}

TEST(SweepCorrection, LeavesScansAsTheyAreWhereOdometryDoesNotReach) {
  const TestRoom room = rectangular_room(6.0, 4.0);
  const Trajectory path{{0.0, {}}, {0.4, {0.0, 0.0, 0.6}}, {2.0, {0.0, 0.0, 3.0}}};
  for (const double time : {1.9, 0.35, 1.0}) {  // after its end, into a gap, within one
    const Trajectory truth{{0.0, {}}, {3.0, {0.0, 0.0, 3.0}}};
    const LaserScan scan = sweep_of(room, truth, time, 0.2 / 360.0, {});
    EXPECT_TRUE(with_corrected_sweep(scan, path).robot_from_beams.empty()) << time;
  }
  EXPECT_TRUE(with_corrected_sweep(sweep_of(room, path, 0.1, 0.2 / 360.0, {}), {})
                  .robot_from_beams.empty());
}

}  // namespace
}  // namespace mapbed
