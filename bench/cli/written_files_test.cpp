// Every file that the commands write, read with the program's own reader; where there is a writer
// of what was read, it gives the same bytes again. What render writes is read in the test of
// render, what a run leaves that is killed in those of the journal and of the staging folder.

#include <filesystem>
#include <functional>
#include <set>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "algorithms/grid/map_file.h"
#include "algorithms/motion/motion_learning.h"
#include "algorithms/pose_graph/graph_file.h"
#include "bench/cli/graph_run.h"
#include "bench/cli/map_run.h"
#include "bench/metrics/evaluation.h"
#include "bench/metrics/relations.h"
#include "bench/pages/html.h"
#include "bench/pages/overview_page.h"
#include "bench/pages/reports.h"
#include "bench/plot/testing/well_formed.h"
#include "bench/results/result_folder.h"
#include "bench/scenario/testing/own_files.h"
#include "bench/sources/log_source.h"
#include "bench/sources/simulation_files.h"
#include "core/file/csv_file.h"
#include "core/file/text_file.h"
#include "core/geometry/tum_file.h"
#include "core/image/map_server.h"
#include "core/image/samples.h"
#include "core/log/log_file.h"
#include "core/testing/test_room.h"
#include "sim/truth/truth_file.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

using Check = std::function<void(const std::string& path)>;

void is_table(const std::string& path) {
  const std::string text = read_text_file(path);
  EXPECT_EQ(csv_text(parse_csv(path, text)), text);
}

void is_trajectory(const std::string& path) {
  const Trajectory trajectory = load_trajectory(path);
  EXPECT_GT(trajectory.size(), 1u);
  EXPECT_EQ(tum_text(trajectory), read_text_file(path));
}

void is_json(const std::string& path) {
  EXPECT_FALSE(nlohmann::json::parse(read_text_file(path)).empty());
}

void is_picture(const std::string& path) {
  EXPECT_GT(read_samples(path).width, 0);
}

void is_svg(const std::string& path) {
  EXPECT_TRUE(is_well_formed(read_text_file(path)));
}

class WrittenFiles : public OwnFiles {
 protected:
  // Each file of a folder by the longest ending that names its kind; all kinds must be met.
  void expect_read(const std::string& folder,
                   const std::vector<std::pair<std::string, Check>>& kinds) {
    std::set<std::string> met;
    for (const auto& entry : fs::recursive_directory_iterator(path(folder))) {
      if (!entry.is_regular_file() || entry.path().filename() == ".lock") continue;
      SCOPED_TRACE(entry.path());
      const std::pair<std::string, Check>* kind = nullptr;
      for (const auto& candidate : kinds) {
        const bool fits = entry.path().string().ends_with(candidate.first);
        if (fits && (kind == nullptr || candidate.first.size() > kind->first.size())) {
          kind = &candidate;
        }
      }
      ASSERT_NE(kind, nullptr) << "nobody reads it";
      ASSERT_NO_THROW(kind->second(entry.path()));
      met.insert(kind->first);
    }
    for (const auto& [ending, check] : kinds) EXPECT_TRUE(met.contains(ending)) << ending;
  }

  void expect_same_result(const std::string& folder) const {
    for (const ResultFile& file : files_of(load_results(path(folder)))) {
      const std::string name = folder + "/" + file.path;
      EXPECT_EQ(file.content, fs::exists(path(name)) ? text(name) : "") << name;
    }
  }
};

TEST_F(WrittenFiles, OfAScenario) {
  run(planned(scenario("room.yaml")), "r");
  expect_same_result("r");
  expect_read("r", {{"config.yaml", [](const std::string& path) { planned(path); }},
                    {".csv", is_table},
                    {".json", is_json},
                    {".svg", is_svg},
                    {".png", is_picture},
                    {".tum", is_trajectory}});
}

TEST_F(WrittenFiles, OfAScenarioWithoutSeriesPlotsAndClaims) {
  const std::string scenario =
      write("y.yaml",
            "world: workshop\nrobot: pioneer\npeople: 0\nrecorder.longest: 1 s\n"
            "estimator: odometry\nmetrics: [path_length]\n");
  run(planned(scenario), "r");
  expect_same_result("r");
  EXPECT_FALSE(fs::exists(path("r/series.csv")));
  EXPECT_FALSE(fs::exists(path("r/figures")));
}

TEST_F(WrittenFiles, OfAScenarioWithAPoseGraph) {
  const std::string scenario =
      write("y.yaml",
            "world: workshop\nrobot: pioneer\npeople: 0\nrecorder.longest: 8 s\n"
            "estimator: graph\nmetrics: [path_length]\n");
  run(planned(scenario), "r");
  expect_same_result("r");
  const auto is_graph = [](const std::string& path) {
    const GraphFile file = load_graph(path);
    EXPECT_GT(file.ids.size(), 2u);
    EXPECT_EQ(graph_text(file.graph, file.ids), read_text_file(path));
  };
  expect_read("r", {{"config.yaml", [](const std::string& path) { planned(path); }},
                    {".csv", is_table},
                    {".json", is_json},
                    {".g2o", is_graph},
                    {".png", is_picture},
                    {".tum", is_trajectory}});
}

struct Simulated : WrittenFiles, ::testing::WithParamInterface<SimulationPlan> {};

TEST_P(Simulated, LogAndAllBesideIt) {
  fs::create_directory(path("s"));
  SimulationPlan plan = GetParam();
  for (std::string* file : {&plan.world, &plan.robot}) {
    if (file->ends_with(".yaml")) *file = path(*file);
  }
  write_simulation(path("s/a.log.gz"), run_simulation(plan, 7));
  const auto is_truth = [&](const std::string& name) {
    write_truth(path("again.gz"), load_truth(name));
    EXPECT_EQ(read_text_file(path("again.gz")), read_text_file(name));
  };
  const auto is_map = [&](const std::string& name) {
    write_map_server(path("again"), read_map_server(name));
    EXPECT_EQ(read_samples(path("again.pgm")),
              read_samples(name.substr(0, name.size() - 4) + "pgm"));
  };
  const auto is_config = [&](const std::string& name) {
    const Scenario scenario = load_scenario(name);
    EXPECT_EQ(scenario.seed, 7u);
    fs::create_directory(path("t"));
    write_simulation(path("t/a.log.gz"),
                     run_simulation(simulation_plan(scenario.settings), scenario.seed));
  };
  std::vector<std::pair<std::string, Check>> kinds = {{".log.gz",
                                                       [](const std::string& path) {
                                                         const RecordedLog log = load_log(path);
                                                         EXPECT_FALSE(log.true_poses.empty());
                                                         EXPECT_TRUE(log.warnings.empty());
                                                       }},
                                                      {".truth.gz", is_truth},
                                                      {".tum", is_trajectory},
                                                      {"_map.yaml", is_map},
                                                      {"_map.pgm", is_picture},
                                                      {".config.yaml", is_config}};
  const bool is_long_enough = path_length(load_trajectory(path("s/a.tum"))) > 5.0;  // [m]
  if (is_long_enough) {
    kinds.emplace_back(".relations",
                       [](const std::string& path) { EXPECT_FALSE(load_relations(path).empty()); });
  }
  expect_read("s", kinds);
  EXPECT_EQ(bytes_of("t"), bytes_of("s"));
}

INSTANTIATE_TEST_SUITE_P(
    WrittenFiles, Simulated,
    ::testing::Values(SimulationPlan{.world = "room.yaml", .robot = "ours.yaml", .people = 0},
                      SimulationPlan{.world = "workshop",
                                     .robot = "b21r",
                                     .driver = "scripted",
                                     .people = 2,
                                     .settings = {parse_setting("recorder.longest=2 s"),
                                                  parse_setting("robot.odometry.rate=7 Hz"),
                                                  parse_setting("recorder.first_stamp=1e9 s")}}));

TEST_F(WrittenFiles, OfAMap) {
  fs::create_directory(path("m"));
  const RecordedLog log =
      drive_through(rectangular_room(6.0, 4.0), {{-1.0, 0.0}, {1.5, 0.5}}, {}, Rng(1));
  const MapConfig config = map_config_from({{"method", "rbpf", {}},
                                            {"rbpf.particles", "2", {}},
                                            {"rbpf.odometry_errors", path("errors.yaml"), {}}});
  const auto always = [](std::size_t, std::size_t) { return true; };
  write_map_run(path("m"), "room.log", log, make_map(prepared(log.measurements), config, always));
  const auto is_config = [&](const std::string& name) {
    EXPECT_EQ(to_yaml(map_config_from(load_settings(name))), read_text_file(name));
  };
  const auto is_map = [&](const std::string& name) {
    write_map(path("again"), read_map(name));
    EXPECT_EQ(read_text_file(path("again.pgm")), text("m/map.pgm"));
  };
  expect_read("m", {{"trajectory.tum", is_trajectory},
                    {"map.yaml", is_map},
                    {"map.pgm", is_map},
                    {".png", is_picture},
                    {"config.yaml", is_config},
                    {".csv", is_table},
                    {"summary.json", is_json}});
}

// Pages are read to see that they may be written over.
TEST_F(WrittenFiles, OfAReport) {
  run(planned(scenario("room.yaml")), "all/r");
  const auto written = write_reports(path("all"));
  EXPECT_EQ(written.size(), 3u);
  for (const std::string& page : written) {
    EXPECT_TRUE(page.ends_with(".md") ? is_markdown_of_ours(page) : is_page_of_ours(page)) << page;
  }
  expect_same_result("all/r");
  const auto before = bytes_of("all");
  write_reports(path("all"));
  EXPECT_EQ(bytes_of("all"), before);
}

TEST_F(WrittenFiles, OfAPoseGraph) {
  for (const std::string suffix : {"g2o", "toro"}) {
    const std::string edges = suffix == "g2o" ? "EDGE_SE2 0 1 1 0 0.5 2 0 0 2 0 2\nFIX 1\n"
                                              : "EDGE2 0 1 1 0 0.5 2 0 2 2 0 0\n";
    const GraphConfig config{.start = GraphStart::chordal};
    fs::create_directory(path(suffix));
    write_graph_run(path(suffix), "a." + suffix,
                    run_graph("a." + suffix, parse_graph("a", edges), config));
    const auto is_graph = [&](const std::string& name) {
      const GraphFile file = load_graph(name);
      EXPECT_EQ(graph_text(file.graph, file.ids, file.format), read_text_file(name));
    };
    const auto is_config = [&](const std::string& name) {
      GraphConfig read;
      apply(load_settings(name), options_of(read), "");
      EXPECT_EQ(read.start, GraphStart::chordal);
      EXPECT_EQ(to_yaml(options_of(read)), read_text_file(name));
    };
    expect_read(suffix, {{"graph." + suffix, is_graph},
                         {"graph.json", is_json},
                         {"picture.svg", is_svg},
                         {"config.yaml", is_config}});
  }
}

TEST_F(WrittenFiles, OfAnEvaluation) {
  const Trajectory truth{{0.0, {0, 0, 0}}, {1.0, {1, 0, 0}}, {2.0, {2, 0, 0}}, {3.0, {2, 1, 1.5}}};
  const Evaluation evaluation{.relations = RelationsError{.count = 3, .mean_translation = 0.25},
                              .truth = compare_with_truth(truth, truth, {})};
  const auto json = nlohmann::json::parse(json_of(evaluation));
  EXPECT_EQ(json.at("relations").at("count"), 3);
  EXPECT_EQ(json.at("relations").at("mean_translation_m"), 0.25);
  EXPECT_EQ(json.at("truth").at("pairs"), 4);
  EXPECT_EQ(json.at("truth").at("estimated_poses"), 4);
  EXPECT_TRUE(json.at("truth").at("over_path").is_object()) << "though the path is too short";
}

// What a drive has learned is what `odometry_errors: FILE` reads.
TEST_F(WrittenFiles, OfWhatWasLearned) {
  run(planned(write("y.yaml",
                    "experiment: motion_models\nworld: hall_loop\nrobot: ours.yaml\npeople: 0\n"
                    "recorder.longest: 150 s\nfilter.particles: 2\nmetrics: [motions]\n"
                    "odometry_file: errors.yaml\n")),
      "r");
  expect_same_result("r");
  ASSERT_TRUE(fs::exists(path("r/learned")));
  for (const auto& entry : fs::recursive_directory_iterator(path("r/learned"))) {
    EXPECT_NO_THROW(load_motion_model(entry.path())) << entry.path();
  }
  run(planned(path("r/config.yaml")), "again");
  EXPECT_EQ(bytes_of("again"), bytes_of("r"));
}

}  // namespace
}  // namespace mapbed
