// A robot with two lasers, one of them tilted: recorded, written and read back, with the truth.

#include <cmath>
#include <map>

#include "bench/sources/simulation_files.h"
#include "core/file/atomic_file.h"
#include "core/geometry/angle.h"
#include "core/log/log_file.h"
#include "core/testing/temporary_folder.h"
#include "sim/truth/truth_file.h"

namespace mapbed {
namespace {

constexpr double kHeight = 0.4;                       // [m] of both lasers
constexpr double kBeamPeriod = 1.0 / (75.0 * 360.0);  // [s] a degree of a mirror at 75 Hz
constexpr double kPitch = 10.0 * kPi / 180.0;         // [rad] of the tilted one

constexpr const char* kRobot = R"(
footprint: {radius: 20 cm}
height: 30 cm
sensors:
  - name: front
    sensor: ./exact.yaml
    x: 10 cm
    z: 40 cm
  - name: tilted
    sensor: ./exact.yaml
    x: 10 cm
    y: 5 cm
    z: 40 cm
    pitch: 10 deg
)";

constexpr const char* kSensor = R"(
kind: laser
beams: 181
max_range: 20 m
divergence: 0
aperture: 0
noise: {sigma_near: 0, sigma_far: 0, step: 0, dark_range: 0, mixed_pixels: off,
        miss_probability: 0, short_probability: 0, random_probability: 0}
)";

constexpr const char* kWorld = R"(
floor: {from: [0 m, 0 m], to: [12 m, 8 m], material: concrete}
walls:
  - {name: south, from: [0 m, 0 m], to: [12 m, 0 m]}
  - {name: east, from: [12 m, 0 m], to: [12 m, 8 m]}
  - {name: north, from: [12 m, 8 m], to: [0 m, 8 m]}
  - {name: west, from: [0 m, 8 m], to: [0 m, 0 m]}
paths:
  ahead: {points: [[2 m, 4 m], [4 m, 4 m]]}
)";

class TwoLasers : public ::testing::Test {
 protected:
  TwoLasers() {
    std::string robot = kRobot;
    const std::string here = folder_.file("exact.yaml");
    for (std::size_t at = 0; (at = robot.find("./exact.yaml", at)) != std::string::npos;) {
      robot.replace(at, std::string("./exact.yaml").size(), here);
      at += here.size();
    }
    write_file(here, kSensor);
    write_file(folder_.file("robot.yaml"), robot);
    write_file(folder_.file("room.yaml"), kWorld);
    const SimulationPlan plan{.world = folder_.file("room.yaml"),
                              .robot = folder_.file("robot.yaml"),
                              .settings = {parse_setting("recorder.longest=2 s")}};
    write_simulation(folder_.file("a.log"), run_simulation(plan, 1));
    log_ = load_log(folder_.file("a.log"));
    truth_ = load_truth(folder_.file("a.truth.gz"));
  }

  std::vector<LaserScan> scans_of(int laser) const {
    std::vector<LaserScan> scans;
    for (const Measurement& m : log_.measurements) {
      const auto* scan = std::get_if<LaserScan>(&m);
      if (scan != nullptr && scan->laser == laser) scans.push_back(*scan);
    }
    return scans;
  }

  TemporaryFolder folder_;
  RecordedLog log_;
  Truth truth_;
};

TEST_F(TwoLasers, AreBothInTheLogWithTheirMountsAndBeamTimes) {
  ASSERT_EQ(scans_of(0).size(), 10u);  // 2 s at 5 Hz
  ASSERT_EQ(scans_of(1).size(), 10u);
  for (const LaserScan& scan : scans_of(0)) {
    EXPECT_TRUE(scan.robot_from_laser.is_level());
    EXPECT_NEAR(scan.robot_from_laser.planar.x, 0.1, 1e-12);
    EXPECT_NEAR(scan.robot_from_laser.z, kHeight, 1e-12);
    EXPECT_NEAR(scan.beam_period, kBeamPeriod, 1e-12);
  }
  for (const LaserScan& scan : scans_of(1)) {
    EXPECT_FALSE(scan.robot_from_laser.is_level());
    EXPECT_NEAR(scan.robot_from_laser.planar.y, 0.05, 1e-12);
    EXPECT_NEAR(scan.robot_from_laser.z, kHeight, 1e-12);
    EXPECT_NEAR(scan.robot_from_laser.pitch, kPitch, 1e-12);
    EXPECT_EQ(scan.robot_from_laser.roll, 0.0);
    EXPECT_NEAR(scan.beam_period, kBeamPeriod, 1e-12);
  }
}

// A plane that is pitched by 10 degrees meets the floor 0.4 m / tan(10 deg) ahead of the laser: at
// bearing b after 0.4 m / (sin(10 deg) cos(b)), before any wall for |b| up to 55 degrees.
TEST_F(TwoLasers, TheTiltedOneSeesTheFloorAndTheOtherTheWallBehind) {
  const std::vector<LaserScan> level = scans_of(0);
  const std::vector<LaserScan> tilted = scans_of(1);
  for (std::size_t i = 0; i < tilted.size(); ++i) {
    for (std::size_t beam = 0; beam < tilted[i].ranges.size(); ++beam) {
      const double bearing = tilted[i].bearing(beam);
      if (std::abs(bearing) > radians(55.0)) continue;
      const double expected = kHeight / (std::sin(kPitch) * std::cos(bearing));
      EXPECT_NEAR(tilted[i].ranges[beam], expected, 1e-4) << bearing;
      EXPECT_GT(level[i].ranges[beam], expected + 0.5) << bearing;
    }
  }
}

TEST_F(TwoLasers, TheTruthNamesWhatEachOfThemMet) {
  ASSERT_EQ(truth_.states.size(), 10u);  // both sweep at the same moments
  ASSERT_EQ(truth_.beams.size(), 20u);
  for (const int laser : {0, 1}) {
    for (const LaserScan& scan : scans_of(laser)) {
      const BeamTruthOfScan* found = beams_of(truth_, scan.time, laser);
      ASSERT_NE(found, nullptr);
      ASSERT_EQ(found->beams.size(), scan.ranges.size());
      const BeamTruth& ahead = found->beams[90];
      const std::string name = truth_.entities[static_cast<std::size_t>(ahead.entity)].name;
      EXPECT_EQ(name, laser == 0 ? "east" : "floor");
      EXPECT_NEAR(ahead.range, scan.ranges[90], 2e-6);  // the file's steps
    }
  }
}

}  // namespace
}  // namespace mapbed
