// A recorded log as the source of a scenario's runs: every kind that 'mapbed map' takes.

#include "bench/sources/recorded_source.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/sources/log_source.h"
#include "core/geometry/angle.h"
#include "core/log/log_file.h"
#include "core/log/log_formats.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

RecordedLog short_log() {
  RecordedLog log;
  for (int k = 0; k < 3; ++k) {
    const double time = 1600000000.0 + 0.25 * k;
    log.measurements.emplace_back(Odometry{time, Pose2{0.25 * k, 0.0, 0.0}});
    LaserScan scan;
    scan.time = time;
    scan.first_bearing = radians(-90.0);
    scan.bearing_step = radians(1.0);
    scan.max_range = 8.0;
    scan.ranges.assign(181, 2.5);
    log.measurements.emplace_back(scan);
  }
  return log;
}

class RecordedSource : public ::testing::Test {
 protected:
  std::string written(const std::string& format, const std::string& name) const {
    log_format_by_name(format).write(folder_.file(name), short_log());
    return folder_.file(name);
  }

  TemporaryFolder folder_;
  SourceParts parts_;
};

TEST_F(RecordedSource, IsALogOfAnyKindThatIsRead) {
  for (const char* format : {"carmen", "carmen_flaser", "ros1", "ros2", "mcap"}) {
    const std::string log = written(format, std::string("drive_") + format);
    const SourcePlan plan = plan_source({{"log", log, {}}}, parts_);
    const auto source = open_source(plan, 1);
    EXPECT_EQ(source->input(plan, 1).log.size(), 6u) << format;
    EXPECT_EQ(source->recorded_seconds(), 0.5) << format;
  }
}

TEST_F(RecordedSource, OfAFolderIsMadeOfAllItsFiles) {
  const std::string log = written("ros2", "drive");
  const SourcePlan plan = plan_source({{"log", log, {}}}, parts_);
  std::vector<std::string> names;
  for (const InputFile& file : plan.files)
    names.push_back(std::filesystem::path(file.path).filename().string());
  EXPECT_THAT(names, ::testing::UnorderedElementsAre("drive_0.db3", "metadata.yaml"));
  std::ofstream(log + "/drive_0.db3", std::ios::app) << "more";
  EXPECT_INPUT_ERROR(open_source(plan, 1), "drive_0.db3: has changed since the runs were planned");
}

TEST_F(RecordedSource, IsNoFolderWithoutABag) {
  EXPECT_INPUT_ERROR(plan_source({{"log", folder_.file("."), {}}}, parts_),
                     "is a folder without a bag in it; give the path of a log, or the folder into "
                     "which ROS 2 has recorded");
  EXPECT_INPUT_ERROR(plan_source({{"log", folder_.file("drive.bag"), {}}}, parts_),
                     "drive.bag' is neither a file nor a folder");
}

TEST_F(RecordedSource, ByItsPathIsToldFromAName) {
  written("ros2", "drive");
  EXPECT_INPUT_ERROR(
      plan_source({{"log", "drive", {folder_.file("x.yaml"), 2}}}, parts_),
      "x.yaml:2: 'drive' is no name that 'mapbed list logs' shows; write ./drive for "
      "the file or folder that is called so");
  EXPECT_INPUT_ERROR(plan_source({{"log", "drove", {folder_.file("x.yaml"), 2}}}, parts_),
                     "unknown log 'drove'");
}

}  // namespace
}  // namespace mapbed
