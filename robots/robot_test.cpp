#include "robots/robot.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/config/settings.h"
#include "core/geometry/angle.h"
#include "core/input_error.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;

// A file that lives as long as the test.
class RobotFile {
 public:
  explicit RobotFile(const std::string& text)
      : path_(std::filesystem::path(::testing::TempDir()) /
              (std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) +
               ".yaml")) {
    std::ofstream(path_) << text;
  }
  ~RobotFile() { std::filesystem::remove(path_); }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

std::string error_of(const std::string& robot_file) {
  const RobotFile file(robot_file);
  try {
    load_robot(file.path());
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Robot, EveryShippedRobotAndSensorLoads) {
  EXPECT_THAT(robot_names(), AllOf(Contains("b21r"), Contains("pioneer")));
  for (const std::string& name : robot_names()) {
    const Robot robot = load_robot(name);
    EXPECT_EQ(robot.name, name);
    EXPECT_GT(robot.footprint.reach(), 0.0);
    EXPECT_FALSE(lasers_of(robot).empty());
    EXPECT_NE(robot.source, "") << name;
  }
  EXPECT_EQ(load_robot("youbot").drive.kind, DriveKind::omni);
  EXPECT_NEAR(load_robot("f1tenth").drive.turning_radius(), 0.3302 / std::tan(0.4189), 1e-9);
  for (const std::string& name : sensor_names()) {
    std::visit([&](const auto& model) { EXPECT_NE(model.source, "") << name; }, load_sensor(name));
  }
}

TEST(Robot, FindsItsSensorsBesideItsFileAndTellsTheFiles) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("sensors"));
  std::ofstream(folder.file("sensors/tiny.yaml")) << "beams: 3\n";
  std::ofstream(folder.file("ours.yaml"))
      << "footprint: {radius: 20 cm}\nsensors: [{name: front, sensor: sensors/tiny.yaml}]\n";
  const Robot robot = load_robot(folder.file("ours.yaml"));
  EXPECT_EQ(lasers_of(robot).at(0).model.beams, 3);
  ASSERT_EQ(robot.files.size(), 2u);
  EXPECT_EQ(robot.files[0].path, folder.file("ours.yaml"));
  EXPECT_EQ(robot.files[1].path, folder.file("sensors/tiny.yaml"));
}

TEST(Robot, TakesWhatItsFileSaysInSiUnits) {
  const RobotFile file(R"(
mass: 20 kg
footprint: {length: 50 cm, width: 400 mm}
drive: {kind: synchro, max_turn_speed: 90 deg/s}
sensors:
  - {name: front, sensor: sick_lms200, x: 10 cm, heading: 180 deg, pitch: 10 deg,
     scan_rate: 10 Hz}
)");
  const Robot robot = load_robot(file.path());

  EXPECT_DOUBLE_EQ(robot.mass, 20.0);
  EXPECT_DOUBLE_EQ(robot.footprint.reach(), std::hypot(0.5, 0.4) / 2.0);
  EXPECT_EQ(robot.drive.kind, DriveKind::synchro);
  EXPECT_NEAR(robot.drive.max_turn_speed, kPi / 2.0, 1e-12);
  ASSERT_EQ(robot.sensors.size(), 1u);
  EXPECT_EQ(robot.sensors[0].name, "front");
  EXPECT_EQ(robot.sensors[0].file, "sick_lms200");
  const MountedLaser laser = lasers_of(robot).at(0);
  EXPECT_DOUBLE_EQ(laser.robot_from_laser.planar.x, 0.1);
  EXPECT_NEAR(laser.robot_from_laser.planar.theta, kPi, 1e-12);
  EXPECT_DOUBLE_EQ(laser.robot_from_laser.z, 0.4);
  EXPECT_NEAR(laser.robot_from_laser.pitch, radians(10.0), 1e-12);
  EXPECT_EQ(laser.model.beams, 180);              // from the sensor's file
  EXPECT_DOUBLE_EQ(laser.model.scan_rate, 10.0);  // and what differs from it
}

TEST(Robot, AMisspeltNameGetsASuggestion) {
  try {
    load_robot("pionere");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("unknown robot 'pionere'; did you mean 'pioneer'?"));
  }
}

TEST(Robot, AMissingFileIsNamed) {
  try {
    load_robot("no/such/robot.yaml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no/such/robot.yaml: there is no such file"));
  }
}

TEST(Robot, AnUnknownKeyIsRefusedWithPlaceAndRemedy) {
  EXPECT_THAT(
      error_of("footprint: {radius: 20 cm}\ndrive: {fricton: 0.5}\n"),
      AllOf(HasSubstr(".yaml:2: unknown key 'fricton'"), HasSubstr("did you mean 'friction'?")));
}

TEST(Robot, AnUnknownSensorIsRefusedWithPlaceAndRemedy) {
  EXPECT_THAT(error_of("footprint: {radius: 20 cm}\nsensors:\n- {name: a, sensor: sick_lms20}\n"),
              AllOf(HasSubstr(".yaml:3: unknown sensor 'sick_lms20'"),
                    HasSubstr("did you mean 'sick_lms200'?")));
}

TEST(Robot, AFootprintIsACircleOrABox) {
  const std::string expected = "neither a circle nor a box; give either radius";
  EXPECT_THAT(error_of("footprint: {length: 20 cm}\n"), HasSubstr(expected));
  EXPECT_THAT(error_of("footprint: {length: 2 m, width: 1 m, radius: 1 m}\n"), HasSubstr(expected));
  EXPECT_THAT(error_of("mass: 3 kg\n"), HasSubstr("footprint"));
  EXPECT_THAT(error_of("footprint: {radius: 4 mm}\n"), HasSubstr("is narrower than 1 cm"));
  EXPECT_THAT(error_of("footprint: {length: 2 m, width: 9 mm}\n"), HasSubstr("narrower than 1 cm"));
}

TEST(Robot, ACarNeedsAWheelBase) {
  EXPECT_THAT(error_of("footprint: {radius: 20 cm}\ndrive: {kind: ackermann}\n"),
              HasSubstr("a car without a wheel base cannot be steered; give drive.wheel_base"));
  EXPECT_THAT(error_of("footprint: {radius: 20 cm}\ndrive: {kind: ackermann, wheel_base: 30 cm}\n"),
              HasSubstr("no error"));
}

TEST(Robot, OdometryByComponentsHasNoStartTurn) {
  EXPECT_THAT(error_of("footprint: {radius: 20 cm}\n"
                       "odometry: {errors: components, start_turn_per_meter: 1 deg}\n"),
              HasSubstr("odometry with errors of components has no start turn"));
}

TEST(Robot, WhatSettingsMadeOfItIsCheckedAgain) {
  Robot robot = load_robot("b21r");
  EXPECT_NO_THROW(check_robot(robot, {}));
  robot.footprint.radius = 0.0;
  EXPECT_THROW(check_robot(robot, {}), InputError);
  robot.footprint.radius = 0.3;
  std::get<LaserModel>(robot.sensors[0].model).scan_rate = 100.0;  // the mirror turns at 75 Hz
  EXPECT_THROW(check_robot(robot, {}), InputError);
}

TEST(Robot, TwoLasersOfOneNameAreRefused) {
  EXPECT_THAT(error_of("footprint: {radius: 20 cm}\nsensors:\n- {name: a, sensor: sick_lms200}\n"
                       "- {name: a, sensor: sick_lms200}\n"),
              HasSubstr(".yaml:4: a second sensor is called 'a'"));
}

TEST(Robot, NegativeAndSenselessValuesAreRefused) {
  EXPECT_THAT(error_of("footprint: {radius: 20 cm}\nmass: -3 kg\n"), HasSubstr(".yaml:2:"));
  EXPECT_THAT(error_of("footprint: {radius: 20 cm}\nmass: 3 cm\n"), HasSubstr(".yaml:2:"));
  EXPECT_THAT(error_of("footprint: {radius: 20 cm}\nsensors:\n"
                       "- {name: a, sensor: sick_lms200, z: -1 m}\n"),
              HasSubstr(".yaml:3:"));
}

TEST(Robot, OldNamesAreRefusedWithTheNewOnes) {
  EXPECT_THAT(error_of("footprint: {radius: 20 cm}\nlasers:\n- {name: a, sensor: sick_lms200}\n"),
              HasSubstr(".yaml:3: 'lasers' is now 'sensors'"));
  EXPECT_THAT(error_of("footprint: {radius: 20 cm}\nsensors:\n"
                       "- {name: a, sensor: sick_lms200, height: 1 m}\n"),
              HasSubstr(".yaml:3: 'height' is now 'z'"));
}

TEST(Robot, SettingsReachItsSensorsByTheirNames) {
  Robot robot = load_robot("pioneer");
  apply({parse_setting("front.noise.bias=3 cm"), parse_setting("front.pitch=5 deg")},
        options_of(robot), "the robot");
  EXPECT_DOUBLE_EQ(lasers_of(robot)[0].model.noise.bias, 0.03);
  EXPECT_NEAR(lasers_of(robot)[0].robot_from_laser.pitch, radians(5.0), 1e-12);
}

TEST(Robot, CarriesAnotherSensorAtTheSameMount) {
  Robot robot = load_robot("pioneer");
  const Mount mount = robot.sensors[0].robot_from_sensor;
  Settings settings{parse_setting("robot.front.sensor=rplidar_a1"),
                    parse_setting("robot.front.noise.bias=3 cm")};
  exchange_sensors(settings, robot);
  ASSERT_EQ(settings.size(), 1u);  // what is left is for the new one
  EXPECT_EQ(robot.sensors[0].file, "rplidar_a1");
  EXPECT_EQ(lasers_of(robot)[0].model.beams, 360);
  EXPECT_DOUBLE_EQ(lasers_of(robot)[0].robot_from_laser.planar.x, mount.planar.x);
  EXPECT_EQ(robot.files.size(), 3u);  // its own, the old sensor's and the new one's

  settings = {parse_setting("robot.front.sensor=rplidar_b1")};
  try {
    exchange_sensors(settings, robot);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("unknown sensor 'rplidar_b1'; did you mean 'rplidar_"));
  }
}

TEST(Robot, AFileSaysWhatKindOfSensorItIs) {
  const RobotFile laser("kind: laser\nbeams: 2\n");
  EXPECT_EQ(std::get<LaserModel>(load_sensor(laser.path())).beams, 2);
  const RobotFile other("about: a nose\nkind: lasr\n");
  try {
    load_sensor(other.path());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr(".yaml:2: unknown kind 'lasr' of a sensor; did you mean 'laser'?"));
  }
}

// 1000 beams of 15 rays, 10,000 times a second, are 1.5e8 rays a second.
TEST(Robot, ALaserThatSendsMoreRaysThanCanBeCastIsRefused) {
  const std::string laser =
      "footprint: {radius: 20 cm}\nsensors:\n- {name: a, sensor: sick_lms200, beams: 1000, "
      "bearing_step: 0.1 deg, mirror_rate: 0 Hz, scan_rate: 10000 Hz, sub_rays: ";
  EXPECT_THAT(error_of(laser + "15}\n"),
              AllOf(HasSubstr(".yaml:3: the laser sends 1.5e+08 rays a second, of 1e+08 at most"),
                    HasSubstr("lower beams, sub_rays or scan_rate")));
  EXPECT_THAT(error_of(laser + "10}\n"), HasSubstr("no error"));
}

TEST(Robot, ALaserCannotSweepFasterThanItsMirrorTurns) {
  EXPECT_THAT(error_of("footprint: {radius: 20 cm}\nsensors:\n"
                       "- {name: a, sensor: sick_lms200, scan_rate: 76 Hz}\n"),
              HasSubstr(".yaml:3: sweeps come faster than the mirror turns; lower scan_rate"));
  EXPECT_THAT(error_of("footprint: {radius: 20 cm}\nsensors:\n"
                       "- {name: a, sensor: sick_lms200, scan_rate: 75 Hz}\n"),
              HasSubstr("no error"));
}

// Half a turn at 40 Hz takes 12.4 ms; at 75 Hz 6.6 ms, as the LMS 200's.
TEST(Robot, ALaserThatIsStampedInTheMiddleOfALongSweepIsRefused) {
  const std::string laser =
      "footprint: {radius: 20 cm}\nsensors:\n- {name: a, sensor: sick_lms200, mirror_rate: ";
  EXPECT_THAT(error_of(laser + "40 Hz}\n"),
              AllOf(HasSubstr(".yaml:3: a sweep of 12 ms is stamped in its middle"),
                    HasSubstr("take stamp: first_beam")));
  EXPECT_THAT(error_of(laser + "40 Hz, stamp: first_beam}\n"), HasSubstr("no error"));
  EXPECT_THAT(error_of(laser + "75 Hz}\n"), HasSubstr("no error"));
}

TEST(RobotFootprint, ReachesToItsCornersAndHoldsACircle) {
  const RobotFootprint box{.length = 0.8, .width = 0.6};
  EXPECT_DOUBLE_EQ(box.reach(), 0.5);
  EXPECT_DOUBLE_EQ(box.inner_radius(), 0.3);
  const RobotFootprint wide{.length = 0.6, .width = 0.8};
  EXPECT_DOUBLE_EQ(wide.inner_radius(), 0.3);
  const RobotFootprint circle{.radius = 0.25};
  EXPECT_DOUBLE_EQ(circle.reach(), 0.25);
  EXPECT_DOUBLE_EQ(circle.inner_radius(), 0.25);
}

}  // namespace
}  // namespace mapbed
