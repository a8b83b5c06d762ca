#include "core/log/carmen_log.h"

#include <iomanip>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

const LaserScan& scan_at(const RecordedLog& log, std::size_t index) {
  return std::get<LaserScan>(log.measurements.at(index));
}

const Odometry& odometry_at(const RecordedLog& log, std::size_t index) {
  return std::get<Odometry>(log.measurements.at(index));
}

std::string flaser(int beams, double range, double time) {
  std::ostringstream line;
  line << "FLASER " << beams;
  for (int i = 0; i < beams; ++i) line << ' ' << range;
  line << " 9 9 9 1 2 0.5 " << std::setprecision(16) << time << " host 0\n";
  return line.str();
}

TEST(CarmenLog, AnFlaserLineIsOdometryAndThenAScanOfTheSameStamp) {
  const RecordedLog log = parse_log("a.log", flaser(181, 3.25, 12.5));
  ASSERT_EQ(log.measurements.size(), 2u);
  EXPECT_EQ(odometry_at(log, 0).time, 12.5);
  EXPECT_THAT(odometry_at(log, 0).odometry_from_robot, IsNear(Pose2{1, 2, 0.5}, Tolerance{0, 0}));
  const LaserScan& scan = scan_at(log, 1);
  EXPECT_EQ(scan.time, 12.5);
  EXPECT_EQ(scan.ranges, std::vector<double>(181, 3.25));
  EXPECT_EQ(scan.first_bearing, -kPi / 2);
  EXPECT_EQ(scan.bearing_step, radians(1.0));
  EXPECT_EQ(log.format, "CARMEN");
}

}  // namespace
}  // namespace mapbed
