#include "bench/cli/map_run.h"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "algorithms/pose_graph/graph_file.h"
#include "bench/plot/testing/well_formed.h"
#include "bench/results/association_file.h"
#include "bench/results/testing/example_associations.h"
#include "core/file/text_file.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/test_room.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

RecordedLog room_log() {
  return drive_through(rectangular_room(6.0, 4.0), {{-1.0, 0.0}, {1.5, 0.5}}, {}, Rng(1));
}

MapConfig config_of(const std::string& method) {
  return map_config_from({{"method", method, {}}});
}

TEST(MapRun, TakesInTheWholeLog) {
  const RecordedLog log = room_log();
  const MapRun run = make_map(prepared(log.measurements), config_of("odometry"),
                              [](std::size_t, std::size_t) { return true; });
  EXPECT_TRUE(run.complete());
  EXPECT_EQ(run.estimate.trajectory.size(), log.true_poses.size());
  EXPECT_FALSE(known_box(run.map).empty());
}

TEST(MapRun, EndsWithWhatItHasWhenItMayNotGoOn) {
  const RecordedLog log = room_log();
  const MapRun run = make_map(prepared(log.measurements), config_of("odometry"),
                              [](std::size_t done, std::size_t) {
                                return done < 10;  // five pairs of odometry and scan
                              });
  EXPECT_FALSE(run.complete());
  EXPECT_EQ(run.estimate.trajectory.size(), 5U);
  EXPECT_FALSE(known_box(run.map).empty());
}

TEST(MapRun, RefusesAMapThatCannotBeWrittenBeforeTheWorkIsDone) {
  MapConfig config = config_of("odometry");
  config.map.beams.usable_range = 10.0;
  config.map.resolution = 1e-4;
  int asked = 0;
  const auto count = [&](std::size_t, std::size_t) { return ++asked > 0; };
  EXPECT_INPUT_ERROR(make_map(prepared(room_log().measurements), config, count),
                     "the map of the first scan alone is ");
  EXPECT_EQ(asked, 0);
}

TEST(MapRun, WritesNothingOfALaserThatSeesNothing) {
  RecordedLog log = room_log();
  for (Measurement& measurement : log.measurements) {
    auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan != nullptr) std::fill(scan->ranges.begin(), scan->ranges.end(), 0.0);
  }
  const MapRun run = make_map(prepared(log.measurements), config_of("rbpf"),
                              [](std::size_t, std::size_t) { return true; });
  const TemporaryFolder folder;
  EXPECT_INPUT_ERROR(write_map_run(folder.file("."), "blind.log", log, run),
                     "blind.log: no beam of any scan counts");
  EXPECT_TRUE(std::filesystem::is_empty(folder.file(".")));
}

MapRun run_of(const RecordedLog& log, const std::string& method) {
  return make_map(prepared(log.measurements), config_of(method),
                  [](std::size_t, std::size_t) { return true; });
}

TEST(MapRun, WritesThePoseGraphWithANodeWhereThePathIs) {
  const RecordedLog log = room_log();
  const MapRun run = run_of(log, "graph");
  ASSERT_TRUE(run.estimate.graph);
  const TemporaryFolder folder;
  write_map_run(folder.file("."), "room.log", log, run);
  const GraphFile file = load_graph(folder.file("graph.g2o"));
  const auto& graph = std::get<PoseGraph<Pose2>>(file.graph);
  EXPECT_EQ(graph.nodes, run.estimate.graph->nodes);
  EXPECT_EQ(graph.constraints.size(), run.estimate.graph->constraints.size());
  EXPECT_GE(graph.constraints.size() + 1, graph.nodes.size()) << "joined from end to end";
  EXPECT_FALSE(std::filesystem::exists(folder.file("associations.json")));
}

TEST(MapRun, WritesWhatWasAssociatedAndItsPicture) {
  const RecordedLog log = room_log();
  MapRun run = run_of(log, "odometry");
  run.estimate.associations = example_associations();
  const TemporaryFolder folder;
  write_map_run(folder.file("."), "room.log", log, run);
  const std::string json = read_text_file(folder.file("associations.json"));
  EXPECT_EQ(associations_json(parse_associations("associations.json", json)), json);
  EXPECT_TRUE(is_well_formed(read_text_file(folder.file("associations.svg"))));
}

TEST(MapRun, WhatAnOlderMapHadBesidesGoesWithIt) {
  const RecordedLog log = room_log();
  const TemporaryFolder folder;
  write_map_run(folder.file("."), "room.log", log, run_of(log, "graph"));
  ASSERT_TRUE(std::filesystem::exists(folder.file("graph.g2o")));
  write_text_file(folder.file("associations.json"), "somebody's");  // it did not write that
  write_map_run(folder.file("."), "room.log", log, run_of(log, "odometry"));
  EXPECT_FALSE(std::filesystem::exists(folder.file("graph.g2o")));
  EXPECT_EQ(read_text_file(folder.file("associations.json")), "somebody's");
}

}  // namespace
}  // namespace mapbed
