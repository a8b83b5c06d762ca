#include "bench/map_run.h"

#include <gtest/gtest.h>

#include "core/testing/test_room.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

RecordedLog room_log() {
  return drive_through(rectangular_room(6.0, 4.0), {{-1.0, 0.0}, {1.5, 0.5}}, {}, Rng(1));
}

TEST(MapRun, TakesInTheWholeLog) {
  const RecordedLog log = room_log();
  const MapRun run =
      make_map(log, {.method = "odometry"}, [](std::size_t, std::size_t) { return true; });
  EXPECT_TRUE(run.complete());
  EXPECT_EQ(run.estimate.trajectory.size(), log.true_poses.size());
  EXPECT_FALSE(known_box(run.map).empty());
}

TEST(MapRun, EndsWithWhatItHasWhenItMayNotGoOn) {
  const RecordedLog log = room_log();
  const MapRun run = make_map(log, {.method = "odometry"}, [](std::size_t done, std::size_t) {
    return done < 10;  // five pairs of odometry and scan
  });
  EXPECT_FALSE(run.complete());
  EXPECT_EQ(run.estimate.trajectory.size(), 5U);
  EXPECT_FALSE(known_box(run.map).empty());
}

TEST(MapRun, RefusesAMapThatCannotBeWrittenBeforeTheWorkIsDone) {
  MapConfig config{.method = "odometry"};
  config.map.beams.usable_range = 10.0;
  config.map.resolution = 1e-4;
  int asked = 0;
  const auto count = [&](std::size_t, std::size_t) { return ++asked > 0; };
  EXPECT_INPUT_ERROR(make_map(room_log(), config, count), "the map of the first scan alone is ");
  EXPECT_EQ(asked, 0);
}

}  // namespace
}  // namespace mapbed
