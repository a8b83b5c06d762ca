// What is in order is neither changed nor remarked on by the stage in front of all methods: on
// public logs; skipped where MAPBED_DATA does not name the folder that holds them. Simulated drives
// need none.

#include <cstdint>
#include <cstdlib>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/input/geometry_check.h"
#include "algorithms/input/input_stage.h"
#include "algorithms/testing/remark_texts.h"
#include "bench/sources/log_source.h"
#include "core/data_path.h"
#include "core/log/log_description.h"

namespace mapbed {
namespace {

bool are_same(const Measurement& a, const Measurement& b) {
  if (a.index() != b.index() || time_of(a) != time_of(b)) return false;
  if (const auto* odometry = std::get_if<Odometry>(&a)) {
    const auto& other = std::get<Odometry>(b);
    return odometry->odometry_from_robot == other.odometry_from_robot && !other.motion_unknown;
  }
  const auto& scan = std::get<LaserScan>(b);
  return std::get<LaserScan>(a).ranges == scan.ranges && scan.robot_from_beams.empty();
}

class CleanRecordedLog : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const char* const folder = std::getenv("MAPBED_DATA");
    if (folder == nullptr || *folder == '\0') GTEST_SKIP() << "MAPBED_DATA is not set";
  }
};

TEST_P(CleanRecordedLog, IsNotChangedNorRemarkedOn) {
  const SensorLog log =
      open_log(find_data_file("log", "scenarios/logs", GetParam()).string()).measurements;
  const PreparedLog ready = prepared(log);
  EXPECT_THAT(texts_of(ready.remarks), ::testing::IsEmpty());
  ASSERT_EQ(ready.log.size(), log.size());
  std::size_t changed = 0;
  for (std::size_t i = 0; i < log.size(); ++i) changed += are_same(log[i], ready.log[i]) ? 0 : 1;
  EXPECT_EQ(changed, 0U);
}

TEST_P(CleanRecordedLog, KeepsItsGeometryWithoutARemark) {
  RecordedLog log = open_log(find_data_file("log", "scenarios/logs", GetParam()).string());
  const Bearings stated = log.lasers.at(0).bearings;
  EXPECT_THAT(texts_of(choose_geometry(log)), ::testing::IsEmpty());
  EXPECT_EQ(log.lasers[0].bearings, stated);
}

INSTANTIATE_TEST_SUITE_P(InputStage, CleanRecordedLog,
                         ::testing::Values("intel", "intel_910", "fr079", "aces", "freiburg_101",
                                           "seattle"));

// Its three bends are all that the stamps of odometry could be judged by.
TEST(CleanSimulatedDrive, IsNotRemarkedOn) {
  SourceParts parts;
  const SourcePlan plan =
      plan_source({{"world", "loop_corridor", {}}, {"robot", "pioneer", {}}}, parts);
  const std::uint64_t seed = 12;
  const auto source = open_source(plan, seed);
  EXPECT_THAT(texts_of(prepared(source->input(plan, seed).log).remarks), ::testing::IsEmpty());
}

}  // namespace
}  // namespace mapbed
