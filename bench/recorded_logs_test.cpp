// What scan matching and the particle filter have to reach on public logs. Skipped where
// MAPBED_DATA does not name the folder that holds them.

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/rbpf/grid_slam.h"
#include "algorithms/scan/hit_points.h"
#include "algorithms/scan/surface_points.h"
#include "algorithms/scan_matching/correlative_matcher.h"
#include "algorithms/scan_matching/incremental_matcher.h"
#include "bench/metrics/relations.h"
#include "bench/metrics/trajectory_error.h"
#include "core/data_path.h"
#include "core/geometry/angle.h"
#include "core/geometry/tum_file.h"
#include "core/log/bags/bag_writer.h"
#include "core/log/dialects/carmen_log.h"
#include "core/log/log_description.h"
#include "core/random.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {
namespace {

class RecordedLogs : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* const folder = std::getenv("MAPBED_DATA");
    if (folder == nullptr || *folder == '\0') GTEST_SKIP() << "MAPBED_DATA is not set";
    data_ = folder;
  }

  static RecordedLog load(const std::string& name) {
    return open_log(find_data_file("log", "scenarios/logs", name).string());
  }

  static Trajectory path_by_scan_matching(const RecordedLog& log,
                                          const IncrementalMatcherOptions& options = {}) {
    IncrementalMatcher matcher(options);
    for (const Measurement& measurement : log.measurements) matcher.add(measurement);
    return matcher.estimate().trajectory;
  }

  std::string data_;
};

std::vector<LaserScan> scans_in(const RecordedLog& log) {
  std::vector<LaserScan> scans;
  for (const Measurement& measurement : log.measurements) {
    if (const auto* scan = std::get_if<LaserScan>(&measurement)) scans.push_back(*scan);
  }
  return scans;
}

// The global search finds a scan again in a building of 30 m x 30 m, from a guess that is up to
// 7 m and 30 degrees off along each axis. The scans that are looked for are not in the map.
TEST_F(RecordedLogs, CorrelativeMatchingFindsScansAgainInTheWholeIntelMap) {
  const std::vector<LaserScan> scans = scans_in(load("intel_910"));
  const Trajectory reference = load_trajectory(data_ + "/intel/intel_gfs_reference_poses.txt.gz");
  constexpr std::size_t kEvery = 4;
  constexpr double kWindow = 7.0;
  const double turn_window = radians(30.0);
  LikelihoodField field;
  SurfaceMeans means(field.resolution());
  const LocalMapOptions local_map;
  const HitPointOptions hits;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (i % kEvery == 0) continue;
    const Pose2 pose = pose_at(reference, scans[i].time).value();
    means.add(transformed(
        surface_points(scans[i], hits.max_range, local_map.max_gap, field.resolution()), pose));
  }
  field.add(means.means());
  const BoundPyramid pyramid = make_bound_pyramid(field, kWindow);
  const CorrelativeMatcherOptions options{.window = kWindow, .turn_window = turn_window};

  Rng rng(1);
  int tries = 0;
  int found = 0;
  for (std::size_t i = 0; i < scans.size(); i += kEvery, ++tries) {
    const Pose2 truth = pose_at(reference, scans[i].time).value();
    const PosePrior guess{
        .mean = {truth.x + rng.uniform(-kWindow, kWindow), truth.y + rng.uniform(-kWindow, kWindow),
                 normalized_angle(truth.theta + rng.uniform(-turn_window, turn_window))}};
    const FieldPoints points = to_field_points(hit_points(scans[i], hits), field.resolution());
    const Pose2 match = match_correlative(points, field, pyramid, guess, options).map_from_robot;
    if (distance(match, truth) <= 0.15) ++found;
  }
  EXPECT_EQ(tries, 228);
  EXPECT_GE(found, 0.98 * tries);
}

struct RelationsCase {
  std::string name;
  std::string relations;
  std::string odometry;  // how the relations' stamps are reached; empty: linearly
  double largest;        // [m] no more than published for scan matching, Kümmerle et al. (2009)
};

void PrintTo(const RelationsCase& c, std::ostream* stream) {
  *stream << c.name;
}

class Relations : public RecordedLogs, public ::testing::WithParamInterface<RelationsCase> {};

TEST_P(Relations, AreMetByScanMatchingAloneWithAndWithoutOdometry) {
  const RecordedLog log = load(GetParam().name);
  const std::vector<Relation> relations = load_relations(data_ + GetParam().relations);
  const Trajectory odometry =
      GetParam().odometry.empty() ? Trajectory{} : load_trajectory(data_ + GetParam().odometry);
  const RelationsError with = relations_error(path_by_scan_matching(log), relations, odometry);
  EXPECT_EQ(with.skipped, 0);
  EXPECT_LE(with.mean_translation, GetParam().largest);
  IncrementalMatcherOptions blind;
  blind.use_odometry = false;
  const RelationsError without =
      relations_error(path_by_scan_matching(log, blind), relations, odometry);
  EXPECT_LE(without.mean_translation, 2.0 * GetParam().largest);
}

INSTANTIATE_TEST_SUITE_P(RecordedLogs, Relations,
                         ::testing::Values(RelationsCase{"intel", "/intel/intel.relations.gz",
                                                         "/intel/intel_odometry.txt.gz", 0.22},
                                           RelationsCase{"fr079", "/fr079/fr079.relations.gz", "",
                                                         0.25}),
                         [](const auto& tested) { return tested.param.name; });

// The loops of the Intel lab are closed. Kümmerle et al. (2009) measured 0.070 m on these
// relations for the particle filter of GMapping with 50 particles, and 0.220 m for scan matching;
// the filter has its defaults and one seed. Its log holds the 910 scans that GMapping kept.
TEST_F(RecordedLogs, TheParticleFilterIsAsConsistentAsThePublishedOne) {
  const RecordedLog log = load("intel_910");
  const std::vector<Relation> relations = load_relations(data_ + "/intel/intel.relations.gz");
  const Trajectory odometry = load_trajectory(data_ + "/intel/intel_odometry.txt.gz");
  GridSlam filter(GridSlamOptions{}, Rng(1));
  for (const Measurement& measurement : log.measurements) filter.add(measurement);
  filter.finish();
  const RelationsError error = relations_error(filter.estimate().trajectory, relations, odometry);
  EXPECT_EQ(error.skipped, 0);
  EXPECT_LE(error.mean_translation, 0.070);
}

struct ReferenceCase {
  std::string name;
  std::string poses;
};

void PrintTo(const ReferenceCase& c, std::ostream* stream) {
  *stream << c.name;
}

class ReferencePoses : public RecordedLogs, public ::testing::WithParamInterface<ReferenceCase> {};

TEST_P(ReferencePoses, AreMetLocally) {
  const Trajectory estimate = path_by_scan_matching(load(GetParam().name));
  const Trajectory reference = load_trajectory(data_ + GetParam().poses);
  const PoseErrors errors = error_over_path(reference, estimate, 5.0);
  EXPECT_LE(errors.translation.median, 0.10);
  EXPECT_LE(errors.rotation.median, radians(1.5));
}

INSTANTIATE_TEST_SUITE_P(
    RecordedLogs, ReferencePoses,
    ::testing::Values(ReferenceCase{"intel", "/intel/intel_gfs_reference_poses.txt.gz"},
                      ReferenceCase{"fr079", "/fr079/fr079_gfs_reference_poses.txt.gz"},
                      ReferenceCase{"aces", "/radish_gfs/rawodom/aces_reference_poses.txt.gz"},
                      ReferenceCase{"freiburg_101",
                                    "/radish_gfs/rawodom/freiburg-101_reference_poses.txt.gz"}),
    [](const auto& tested) { return tested.param.name; });

class AsABag : public RecordedLogs, public ::testing::WithParamInterface<const char*> {};

// Though it keeps floats. Only how far readings that hit nothing were beyond the maximum range is
// not told by a bag, and nothing here asks.
TEST_P(AsABag, HasTheLogsOwnMeasurementsToTheLastBit) {
  RecordedLog log = load(GetParam());
  for (Measurement& measurement : log.measurements) {
    auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr) continue;
    for (double& range : scan->ranges) range = std::min(range, scan->max_range);
  }
  log.parameters.clear();
  const TemporaryFolder folder;
  write_rosbag1(folder.file("a.bag"), log);
  EXPECT_TRUE(carmen_text(load_log(folder.file("a.bag"))) == carmen_text(log));
}

INSTANTIATE_TEST_SUITE_P(RecordedLogs, AsABag,
                         ::testing::Values("intel_910", "aces", "freiburg_101", "seattle",
                                           "sena_malaga", "scan_tools_demo"));

}  // namespace
}  // namespace mapbed
