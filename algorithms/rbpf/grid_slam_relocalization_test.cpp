// Robots that were carried away, and one that only may have been.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/rbpf/grid_slam.h"
#include "algorithms/rbpf/testing/drives.h"
#include "algorithms/testing/remark_texts.h"

namespace mapbed {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

// Carried 5 m across a known room without its wheels turning, then driving on there.
struct CarriedAway {
  RecordedLog log;
  double time = 0.0;  // [s]
};
CarriedAway carried_away(const TestRoom& there, const std::vector<Eigen::Vector2d>& way_there,
                         const Pose2& jump = {}) {
  DriveOptions drive;
  drive.laser = {.beams = 361, .first_bearing = -kPi, .max_range = 15.0};
  CarriedAway result{
      .log = drive_through(furnished_room(), {{-3, -2}, {3, -2}, {3, 2}, {-3, 2}}, drive, Rng(4))};
  const Pose2 odometry_at_end =
      std::get<Odometry>(result.log.measurements.end()[-2]).odometry_from_robot;
  result.time = drive.start_time = result.log.true_poses.back().time + drive.scan_period;
  RecordedLog after = drive_through(there, way_there, drive, Rng(5));
  for (Measurement& measurement : after.measurements) {
    if (auto* odometry = std::get_if<Odometry>(&measurement)) {
      odometry->odometry_from_robot = odometry_at_end * jump * odometry->odometry_from_robot;
    }
    result.log.measurements.push_back(measurement);
  }
  result.log.true_poses.insert(result.log.true_poses.end(), after.true_poses.begin(),
                               after.true_poses.end());
  return result;
}

class FindsItselfAgain : public ::testing::TestWithParam<Pose2> {};

TEST_P(FindsItselfAgain, AfterItWasCarriedAcrossTheMap) {
  const CarriedAway carried = carried_away(furnished_room(), {{1, -2}, {-3, -1}}, GetParam());
  GridSlamOptions options;
  options.particles = 20;
  const Estimate estimate = run(carried.log, options);
  EXPECT_LT(error_at_end(carried.log, estimate), 0.1);
  EXPECT_THAT(texts_of(estimate.remarks), Contains(HasSubstr("found again at")));
  EXPECT_THAT(texts_of(estimate.remarks), Not(Contains(HasSubstr("is not known"))));
  // So is the whole path, but for the half metre after it, of which nobody can say on which side of
  // the carrying it lies: the next update is made then.
  const Pose2 first = carried.log.true_poses.front().pose;
  for (const Stamped<Pose2>& stamped : estimate.trajectory) {
    if (stamped.time >= carried.time && stamped.time < carried.time + 1.0) continue;
    const Pose2 truth = motion_between(first, *pose_at(carried.log.true_poses, stamped.time));
    EXPECT_LT(distance(stamped.pose, truth), 0.2) << stamped.time;
  }
}

// The odometry's counters stand still, or jump as well.
INSTANTIATE_TEST_SUITE_P(GridSlam, FindsItselfAgain,
                         ::testing::Values(Pose2{}, Pose2{7.0, -3.0, 1.0}));

// Four sides that look alike: the robot may be in any of them, and stays where it was.
TEST(GridSlam, DoesNotLeaveItsPlaceForOneThatLooksTheSame) {
  DriveOptions drive;
  drive.laser.max_range = 15.0;
  const RecordedLog round =
      drive_through(ring_corridor(), {{-5, -5}, {5, -5}, {5, 5}, {-5, 5}, {-5, -5}}, drive, Rng(4));
  const double late = round.true_poses.front().time + 60.0;  // on the third side
  const RecordedLog log = with_jump_of_odometry(round, late);
  GridSlamOptions options;
  options.particles = 20;
  const Estimate estimate = run(log, options);
  EXPECT_LT(error_at_end(log, estimate), 0.5);
  EXPECT_THAT(texts_of(estimate.remarks), Contains(HasSubstr("odometry jumps")));
  EXPECT_THAT(texts_of(estimate.remarks), Not(Contains(HasSubstr("lost"))));
}

// Carried into another place while the wheels stand still: nothing of it is on the map.
TEST(GridSlam, SaysThatItIsLostWhereTheMapExplainsNothing) {
  RecordedLog log = two_rounds();
  DriveOptions drive;
  drive.laser.max_range = 15.0;
  drive.start_time = log.true_poses.back().time + 1.0;
  TestRoom elsewhere({});
  Rng rng(3);
  for (int i = 0; i < 150; ++i) {
    elsewhere.add_box({rng.uniform(-12, 12), rng.uniform(-12, 12)}, rng.uniform(0.2, 0.5),
                      rng.uniform(0.2, 0.5), rng.uniform(0, 3));
  }
  const RecordedLog after = drive_through(elsewhere, {{-9.9, 0}, {9.9, 0.1}}, drive, Rng(4));
  GridSlamOptions options;
  options.particles = 20;
  GridSlam slam(options, Rng(1));
  for (const Measurement& measurement : log.measurements) slam.add(measurement);
  EXPECT_THAT(texts_of(slam.estimate().remarks), Not(Contains(HasSubstr("lost"))));
  for (const Measurement& measurement : after.measurements) slam.add(measurement);
  const Estimate estimate = slam.estimate();
  for (const Stamped<Pose2>& stamped : estimate.trajectory) EXPECT_TRUE(is_finite(stamped.pose));
  EXPECT_THAT(texts_of(estimate.remarks), Contains(HasSubstr("lost from")));
}

// Scans among leaves fit nowhere, and the map explains next to nothing of them. Odometry goes on
// all the while: to look for the robot does not harm.
TEST(GridSlam, IsNotWorseForLookingForItselfWhereScansFitNowhere) {
  DriveOptions drive;
  drive.laser = {.beams = 91, .first_bearing = -kPi, .max_range = 15.0};
  RecordedLog log =
      drive_through(furnished_room(), {{-3, -2}, {3, -2}, {3, 2}, {-3, 2}}, drive, Rng(4));
  const double middle = 0.5 * (log.true_poses.front().time + log.true_poses.back().time);
  Rng rng(7);
  for (Measurement& measurement : log.measurements) {
    auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr || std::abs(scan->time - middle) > 0.6) continue;
    for (double& range : scan->ranges) range = rng.uniform(0.5, 14.0);
  }
  GridSlamOptions options;
  options.particles = 10;
  const Estimate looking = run(log, options);
  EXPECT_THAT(texts_of(looking.remarks), Contains(HasSubstr("lost")));
  options.relocalization.max_updates = 0;
  EXPECT_EQ(error_at_end(log, looking), error_at_end(log, run(log, options)));
}

TEST(GridSlam, IsLostWhereItWasCarriedIntoTheUnknown) {
  TestRoom elsewhere = rectangular_room(5.0, 14.0);
  elsewhere.add_box({1.0, 3.0}, 0.6, 0.9, 0.4);
  elsewhere.add_box({-1.4, -4.0}, 1.6, 0.4, 0.8);
  const CarriedAway carried = carried_away(elsewhere, {{0, -5}, {0, 5}}, {7.0, -3.0, 1.0});
  GridSlamOptions options;
  options.particles = 20;
  const Estimate estimate = run(carried.log, options);
  for (const Stamped<Pose2>& stamped : estimate.trajectory) EXPECT_TRUE(is_finite(stamped.pose));
  EXPECT_THAT(texts_of(estimate.remarks), Not(Contains(HasSubstr("found again"))));
  EXPECT_THAT(texts_of(estimate.remarks), Contains(HasSubstr("lost from")));
}

}  // namespace
}  // namespace mapbed
