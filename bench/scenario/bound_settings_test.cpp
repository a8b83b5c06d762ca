// A scenario's settings are bound when it is planned: files that change or go afterwards change
// nothing.

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include "bench/scenario/runner.h"
#include "bench/sources/simulation_files.h"
#include "core/data_path.h"
#include "core/file/hash.h"
#include "core/file/text_file.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {
namespace {

constexpr const char* kRoom =
    "about: An empty room\n"
    "floor: {from: [0 m, 0 m], to: [8 m, 6 m], material: carpet}\n"
    "walls:\n"
    "  - {from: [0 m, 0 m], to: [8 m, 0 m]}\n"
    "  - {from: [8 m, 0 m], to: [8 m, 6 m]}\n"
    "  - {from: [8 m, 6 m], to: [0 m, 6 m]}\n"
    "  - {from: [0 m, 6 m], to: [0 m, 0 m]}\n"
    "paths: {across: {points: [[1 m, 2 m], [7 m, 2 m]]}}\n";

class BoundSettings : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.file(name)) << text;
    return folder_.file(name);
  }
  // A robot of our own, whose file can go.
  std::string robot() const {
    return write("ours.yaml",
                 read_text_file(find_data_file("robot", "robots", "pioneer").string()));
  }
  ScenarioPlan plan(const std::string& yaml) const {
    return make_plan(load_scenario(write("x.yaml", yaml)));
  }
  // Every value of every run.
  static std::vector<std::vector<double>> values_of(const ScenarioPlan& plan) {
    std::vector<std::vector<double>> values(static_cast<std::size_t>(plan.runs()));
    const RunnerCalls calls{[&](const RunResult& result) {
                              EXPECT_EQ(result.row.failure, "");
                              values[static_cast<std::size_t>(result.row.run)] = result.row.values;
                            },
                            [] { return true; }};
    do_runs(plan, plan.runs_to_do(), 2, calls);
    return values;
  }

  TemporaryFolder folder_;
};

TEST_F(BoundSettings, RobotAndWorldAreNotReadAgain) {
  const std::string world = write("room.yaml", kRoom);
  const std::string robot = this->robot();
  const ScenarioPlan plan = this->plan("world: " + world + "\nrobot: " + robot +
                                       "\nrecorder.longest: 2 s\nestimator: odometry\n"
                                       "sweep: {robot.odometry.distance_per_meter: [0 cm, 5 cm]}\n"
                                       "metrics: [translation_error, path_length]\n");
  const auto before = values_of(plan);
  ASSERT_EQ(before.size(), 2u);
  EXPECT_NE(before[0], before[1]);
  std::ofstream(robot) << "about: another one\n";
  std::filesystem::remove(world);
  EXPECT_EQ(values_of(plan), before);
}

TEST_F(BoundSettings, TheDescriptionOfALogIsNotReadAgain) {
  const std::string log = folder_.file("drive.log");
  SimulationPlan drive{.world = "corridor", .robot = "pioneer", .people = 0};
  drive.settings = {parse_setting("recorder.longest=2 s")};
  write_simulation(log, run_simulation(drive, 1));
  const std::string description =
      write("drive.yaml", "about: a drive\nfile: drive.log\nsha256: " + sha256_of_file(log) +
                              "\nsource: simulated\nlicence: ours\nfetch: simulate it\n"
                              "robot: Pioneer\nlaser: SICK\nlog: {max_range: 5 m}\n");
  const ScenarioPlan plan = this->plan("log: " + description +
                                       "\nestimator: scan_matching\n"
                                       "metrics: [path_length, sharpness]\n");
  const auto before = values_of(plan);
  std::filesystem::remove(description);
  EXPECT_EQ(values_of(plan), before);
}

}  // namespace
}  // namespace mapbed
