#include "bench/scenario/testing/own_files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "bench/results/figures.h"
#include "bench/scenario/run_scenario.h"
#include "bench/sources/simulation_files.h"
#include "core/file/text_file.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRoom =
    "floor: {from: [0 m, 0 m], to: [8 m, 6 m], material: carpet}\n"
    "walls:\n"
    "  - {from: [0 m, 0 m], to: [8 m, 0 m]}\n"
    "  - {from: [8 m, 0 m], to: [8 m, 6 m]}\n"
    "  - {from: [8 m, 6 m], to: [0 m, 6 m]}\n"
    "  - {from: [0 m, 6 m], to: [0 m, 0 m]}\n"
    "shapes: [{name: tent, mesh: meshes/tent.obj, at: [4 m, 5 m]}]\n"
    "paths: {across: {points: [[1 m, 2 m], [7 m, 2 m]]}}\n";

constexpr const char* kTent =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.3 0.3 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

// A room of 8 m x 6 m with pixels of half a metre.
std::string plan_picture() {
  std::string pixels;
  for (int y = 0; y < 12; ++y) {
    for (int x = 0; x < 16; ++x) {
      const bool is_wall = x == 0 || y == 0 || x == 15 || y == 11;
      pixels += is_wall ? '\0' : '\xfe';
    }
  }
  return "P5\n16 12\n255\n" + pixels;
}

constexpr const char* kPlan =
    "image: plan.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

constexpr const char* kRobot =
    "footprint: {radius: 20 cm}\nheight: 30 cm\n"
    "sensors: [{name: front, sensor: sensors/laser.yaml, z: 25 cm}]\n";

constexpr const char* kErrors =
    "rotation_per_rotation: 4 deg\nrotation_per_meter: 1 deg\ntranslation_per_meter: 2 cm\n";

}  // namespace

OwnFiles::OwnFiles() {
  for (const char* inner : {"meshes", "sensors"}) fs::create_directory(path(inner));
  write("room.yaml", kRoom);
  write("meshes/tent.obj", kTent);
  write("planned.yaml",
        "plan: {file: plan.yaml, height: 2 m}\n"
        "paths: {across: {points: [[1 m, 2 m], [7 m, 2 m]]}}\n");
  write("plan.yaml", kPlan);
  write("plan.pgm", plan_picture());
  write("started.yaml", "start: corridor\noptions: {length: 12 m}\n");
  write("ours.yaml", kRobot);
  write("sensors/laser.yaml", "kind: laser\nbeams: 91\nbearing_step: 2 deg\nmax_range: 20 m\n");
  write("errors.yaml", kErrors);
}

std::string OwnFiles::text(const std::string& name) const {
  return read_text_file(path(name));
}

std::string OwnFiles::write(const std::string& name, const std::string& text) const {
  std::ofstream(path(name)) << text;
  return path(name);
}

std::string OwnFiles::scenario(const std::string& world, const std::string& more) const {
  return write("x.yaml", "about: our own files\nworld: " + world +
                             "\nrobot: ours.yaml\npeople: 0\nrecorder.longest: 1 s\n"
                             "rbpf: {particles: 2, odometry_errors: errors.yaml}\n"
                             "sweep: {robot.odometry.distance_per_meter: [0 cm, 5 cm]}\n"
                             "compare: {raw: {estimator: odometry}, filter: {estimator: rbpf}}\n"
                             "series_step: 0.5 s\n"
                             "metrics: [path_length, largest_error, position_error]\n"
                             "plots: [{y: path_length}, {kind: series, y: position_error}]\n"
                             "claims: [{metric: largest_error, of: filter, at_most: raw}]\n" +
                             more);
}

void OwnFiles::write_log(const std::string& name) const {
  SimulationPlan drive{.world = "corridor", .robot = path("ours.yaml"), .people = 0};
  drive.settings = {parse_setting("recorder.longest=5 s")};
  write_simulation(path(name), run_simulation(drive, 1));
}

ScenarioPlan OwnFiles::planned(const std::string& scenario, const std::vector<std::string>& set) {
  ScenarioChoice choice;
  for (const std::string& text : set) choice.settings.push_back(parse_setting(text));
  return make_plan(load_scenario(scenario, choice));
}

Results OwnFiles::run(const ScenarioPlan& plan, const std::string& folder) const {
  fs::create_directories(path(folder));
  const ScenarioRun run = run_scenario(plan, {.folder = path(folder), .threads = 2},
                                       [](std::size_t, std::size_t) { return true; });
  EXPECT_TRUE(run.complete);
  for (const RunRow& row : run.results.runs) EXPECT_EQ(row.failure, "");
  write_figures(path(folder), run.results);
  return run.results;
}

std::vector<std::pair<std::string, std::string>> OwnFiles::bytes_of(
    const std::string& folder) const {
  std::vector<std::pair<std::string, std::string>> bytes;
  for (const auto& entry : fs::recursive_directory_iterator(path(folder))) {
    const std::string name = fs::relative(entry.path(), path(folder)).string();
    const bool differs = name == "cost.csv" || name == "cost_claims.csv" ||
                         name == "provenance.json" || name == ".lock";
    if (entry.is_regular_file() && !differs) bytes.emplace_back(name, text(folder + "/" + name));
  }
  std::sort(bytes.begin(), bytes.end());
  return bytes;
}

}  // namespace mapbed
