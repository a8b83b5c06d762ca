// A laser that takes a whole period for its turn, on a robot that drives and turns: with the stamps
// of the simulated log, the beams' places as methods get them are those where they were sent.

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "algorithms/input/input_stage.h"
#include "bench/sources/simulate.h"
#include "core/file/atomic_file.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {
namespace {

constexpr double kLength = 6.0, kWidth = 4.0;  // [m] of the room

constexpr const char* kRobot = R"(
footprint: {radius: 20 cm}
height: 50 cm
odometry: {source: truth}
sensors:
  - {name: front, sensor: ./exact.yaml, z: 40 cm}
)";

constexpr const char* kSensor = R"(
kind: laser
beams: 360
first_bearing: -180 deg
max_range: 20 m
scan_rate: 10 Hz
mirror_rate: 10 Hz
divergence: 0
aperture: 0
noise: {sigma_near: 0, sigma_far: 0, step: 0, dark_range: 0, mixed_pixels: off,
        miss_probability: 0, short_probability: 0, random_probability: 0}
)";

constexpr const char* kWorld = R"(
floor: {from: [0 m, 0 m], to: [6 m, 4 m], material: concrete}
walls:
  - {name: south, from: [0 m, 0 m], to: [6 m, 0 m], thickness: 1 mm}
  - {name: east, from: [6 m, 0 m], to: [6 m, 4 m], thickness: 1 mm}
  - {name: north, from: [6 m, 4 m], to: [0 m, 4 m], thickness: 1 mm}
  - {name: west, from: [0 m, 4 m], to: [0 m, 0 m], thickness: 1 mm}
paths:
  corner: {points: [[1.5 m, 1.5 m], [3.5 m, 1.5 m], [3.5 m, 2.5 m]]}
)";

SimulationResult drive(const TemporaryFolder& folder) {
  std::string robot = kRobot;
  robot.replace(robot.find("./exact.yaml"), 12, folder.file("exact.yaml"));
  write_file(folder.file("exact.yaml"), kSensor);
  write_file(folder.file("robot.yaml"), robot);
  write_file(folder.file("room.yaml"), kWorld);
  return run_simulation({.world = folder.file("room.yaml"), .robot = folder.file("robot.yaml")}, 1);
}

// [m] from a point to the nearest wall's middle.
double off_the_walls(const Eigen::Vector2d& p) {
  return std::min(
      {std::abs(p.x()), std::abs(p.x() - kLength), std::abs(p.y()), std::abs(p.y() - kWidth)});
}

TEST(SweptScans, BeamsOfASlowMirrorMeetTheWallsFromWhereTheyWereSent) {
  const TemporaryFolder folder;
  SimulationResult simulated = drive(folder);
  const Trajectory truth = trajectory_of(simulated.recording.truth);
  int corrected = 0;
  for (const Measurement& measurement : prepared(std::move(simulated.log)).log) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr || scan->robot_from_beams.empty()) continue;
    ++corrected;
    const Pose2 pose = *pose_at(truth, scan->time);
    for (std::size_t k = 0; k < scan->ranges.size(); ++k) {
      // By half a sweep more the robot turns up to 0.05 rad: 20 cm at 4 m.
      EXPECT_LT(off_the_walls(pose * scan->point_on(k, scan->ranges[k])), 0.03) << scan->time;
    }
  }
  EXPECT_GT(corrected, 30);
}

}  // namespace
}  // namespace mapbed
