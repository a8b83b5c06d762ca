#include "bench/cli/map_run.h"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace mapbed
