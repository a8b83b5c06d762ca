// Logs in which something is missing or wrong: the filter goes on, and says so.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/rbpf/grid_slam.h"
#include "algorithms/rbpf/testing/drives.h"
#include "algorithms/testing/remark_texts.h"
#include "core/geometry/angle.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;

double half_time_of(const RecordedLog& log) {
  return 0.5 * (log.true_poses.front().time + log.true_poses.back().time);
}

TEST(GridSlam, StaysFiniteWhenTheLaserSeesNothingAndSaysSo) {
  GridSlamOptions options;
  options.particles = 5;
  GridSlam slam(options, Rng(1));
  for (int i = 0; i < 20; ++i) {
    slam.add(Odometry{.time = 1.0 * i, .odometry_from_robot = {0.6 * i, 0.0, 0.0}});
    LaserScan blind{.time = 1.0 * i, .bearing_step = 0.02, .max_range = 8.0};
    blind.ranges.assign(100, 8.0);
    slam.add(blind);
  }
  const Estimate estimate = slam.estimate();
  for (const Stamped<Pose2>& stamped : estimate.trajectory) EXPECT_TRUE(is_finite(stamped.pose));
  EXPECT_NEAR(estimate.trajectory.back().pose.x, 0.6 * 19, 2.0);  // where odometry has it
  EXPECT_THAT(texts_of(estimate.remarks),
              Contains(HasSubstr("the laser sees nothing from 0.0 s to 19.0 s")));
}

TEST(GridSlam, WorksWithoutOdometryAndSaysSo) {
  const RecordedLog log = without_odometry(two_rounds());
  GridSlamOptions options;
  options.particles = 20;
  const Estimate estimate = run(log, options);
  EXPECT_LT(error_at_end(log, estimate), 0.5);
  EXPECT_THAT(texts_of(estimate.remarks),
              Contains(AllOf(HasSubstr("no odometry from"),
                             HasSubstr("scans alone say how the robot moves"))));
}

TEST(GridSlam, TheStandardFilterStandsStillWithoutOdometryAndSaysSo) {
  GridSlamOptions options;
  options.particles = 2;
  options.proposal = Proposal::odometry;
  const Estimate estimate = run(without_odometry(two_rounds()), options);
  for (const Stamped<Pose2>& stamped : estimate.trajectory) {
    // Scans between updates are matched about where they are taken to be, which is held to be right
    // to this.
    const MotionModelOptions& errors = options.odometry_errors;
    EXPECT_THAT(stamped.pose, IsNear(Pose2{}, Tolerance{5 * errors.least_translation_sigma,
                                                        5 * errors.least_rotation_sigma}));
  }
  EXPECT_EQ(estimate.untrusted_scans, static_cast<int>(estimate.trajectory.size()) - 1);
  EXPECT_THAT(texts_of(estimate.remarks),
              Contains(AllOf(HasSubstr("no odometry from"), HasSubstr("taken as standing still"))));
}

TEST(GridSlam, OutlivesAJumpOfOdometryAndSaysSo) {
  const RecordedLog drive = two_rounds();
  const RecordedLog log = with_jump_of_odometry(drive, half_time_of(drive));
  GridSlamOptions options;
  options.particles = 20;
  const Estimate estimate = run(log, options);
  EXPECT_LT(error_at_end(log, estimate), 0.5);
  EXPECT_THAT(texts_of(estimate.remarks), Contains(HasSubstr("odometry jumps from")));
}

TEST(GridSlam, OutlivesTenSecondsWithoutScansAndSaysSo) {
  RecordedLog log = two_rounds();
  const double half = half_time_of(log);
  std::erase_if(log.measurements, [&](const Measurement& m) {
    return std::holds_alternative<LaserScan>(m) && time_of(m) > half && time_of(m) < half + 10.0;
  });
  GridSlamOptions options;
  options.particles = 20;
  const Estimate estimate = run(log, options);
  EXPECT_LT(error_at_end(log, estimate), 0.5);
  EXPECT_THAT(texts_of(estimate.remarks), Contains(HasSubstr("no scan from")));
}

// One scan every two seconds, and odometry misses the turn of 90 degrees at the first corner. The
// wheels tell of a step straight on, which they believe to a few degrees.
TEST(GridSlam, BelievesTheScansWhereTheyRefuteOdometry) {
  DriveOptions drive;
  drive.laser = {.beams = 361, .first_bearing = -kPi, .max_range = 15.0};
  RecordedLog log = drive_through(furnished_room(), {{-3, -2}, {3, -2}, {3, 2}, {-3, 2}, {-3, -1}},
                                  drive, Rng(4));
  const double start = log.true_poses.front().time;
  Pose2 last, told;
  for (Measurement& measurement : log.measurements) {
    auto* odometry = std::get_if<Odometry>(&measurement);
    if (odometry == nullptr) continue;
    Pose2 step = motion_between(last, odometry->odometry_from_robot);
    last = odometry->odometry_from_robot;
    // 12 s to the first corner, 2 s there.
    const double time = odometry->time - start;
    if (time > 11.0 && time < 15.0) step.theta = 0.0;
    told = told * step;
    odometry->odometry_from_robot = told;
  }
  int number = 0;
  std::erase_if(log.measurements, [&](const Measurement& m) {
    return std::holds_alternative<LaserScan>(m) && number++ % 8 != 0;
  });
  GridSlamOptions options;
  options.particles = 20;
  const Estimate estimate = run(log, options);
  EXPECT_LT(error_at_end(log, estimate), 0.1);
}

}  // namespace
}  // namespace mapbed
