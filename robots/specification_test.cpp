#include "robots/specification.h"

#include <gmock/gmock.h>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

TEST(Specification, OfALaserNamesWhatIsComparedFirst) {
  LaserModel laser;
  laser.beams = 541;
  laser.bearing_step = radians(0.5);
  laser.min_range = 0.5;
  laser.max_range = 20.0;
  laser.scan_rate = 50.0;
  laser.noise = {.sigma_near = 0.012, .sigma_far = 0.012, .bias_spread = 0.015, .step = 0.001};
  EXPECT_EQ(specification(laser),
            "0.5 to 20 m, 270 deg in 541 beams of 0.5 deg, 50 Hz, sigma 12 mm, devices differ by "
            "15 mm, steps of 1 mm");
}

TEST(Specification, ErrorsThatGrowAreToldWithTheirRanges) {
  LaserModel laser;
  laser.noise.scale_spread = 0.005;
  EXPECT_THAT(specification(laser), HasSubstr("sigma 5 mm to 8 m, then up to 10 mm at 20 m, "
                                              "devices differ by 0.5 %, steps of 10 mm"));
  laser.noise.sigma_near = laser.noise.near_range = 0.0;
  laser.noise.sigma_far = 0.03;
  laser.noise.far_range = 10.0;
  EXPECT_THAT(specification(laser), HasSubstr("sigma 0.3 % of the range to 10 m,"));
}

TEST(Specification, OfARobotNamesSizeDriveAndSensors) {
  Robot robot;
  robot.footprint.radius = 0.25;
  robot.height = 0.5;
  robot.mass = 20.0;
  robot.drive.max_turn_speed = radians(90.0);
  robot.sensors = {{.name = "front", .file = "sick_lms111"}};
  EXPECT_EQ(specification(robot),
            "0.5 m across, 0.5 m high, 20 kg, differential, 0.8 m/s, 90 deg/s, front sick_lms111");
  robot.footprint = {.length = 0.58, .width = 0.31};
  EXPECT_THAT(specification(robot), HasSubstr("0.58 x 0.31 m"));
}

}  // namespace
}  // namespace mapbed
