// What the front end and the filter of chapter 3 have to reach on scans of real people, annotated
// by others. Skipped where MAPBED_DATA does not name the folder that holds them.

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/people/front_end/leg_features.h"
#include "algorithms/people/front_end/scan_view.h"
#include "algorithms/people/tracking_filter.h"
#include "core/file/text_file.h"
#include "core/log/log_description.h"
#include "core/random.h"

namespace mapbed {
namespace {

constexpr double kNear = 0.25;  // [m] of a feature and the cluster that it stands for

using Clusters = std::vector<Eigen::Vector2d>;  // [m] in the frame of the laser

class RecordedPeople : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* const folder = std::getenv("MAPBED_DATA");
    if (folder == nullptr || *folder == '\0') GTEST_SKIP() << "MAPBED_DATA is not set";
    data_ = std::string(folder) + "/people_leg_tracker/";
  }

  std::vector<LaserScan> scans_of(const std::string& run) const {
    std::vector<LaserScan> scans;
    for (const Measurement& measurement : open_log(data_ + run + ".scans.gz").measurements) {
      if (const auto* scan = std::get_if<LaserScan>(&measurement)) scans.push_back(*scan);
    }
    return scans;
  }

  // Legs that people marked, a line `t n x y x y ...` for each scan; some lines have no stamp.
  std::vector<Clusters> annotation(const std::string& run) const {
    std::vector<Clusters> by_scan;
    std::istringstream lines(read_text_file(data_ + run + ".legs.gz"));
    for (std::string line; std::getline(lines, line);) {
      if (line.empty() || line.front() == '#') continue;
      std::istringstream fields(line);
      double stamp = 0.0;
      std::size_t count = 0;
      fields >> stamp >> count;
      Clusters& clusters = by_scan.emplace_back();
      for (double x = 0.0, y = 0.0; fields >> x >> y;) clusters.emplace_back(x, y);
      EXPECT_EQ(clusters.size(), count) << line;
    }
    return by_scan;
  }

  std::string data_;
};

bool has_near(const std::vector<LegFeature>& features, const Eigen::Vector2d& cluster) {
  return std::any_of(features.begin(), features.end(), [&](const LegFeature& feature) {
    return (feature.position - cluster).norm() <= kNear;
  });
}

class RecordedLegs : public RecordedPeople, public ::testing::WithParamInterface<std::string> {};

// The annotation of a run is not complete, so that what else is found says nothing.
TEST_P(RecordedLegs, AreFeaturesOfTheirScan) {
  const std::vector<LaserScan> scans = scans_of(GetParam());
  const std::vector<Clusters> annotated = annotation(GetParam());
  ASSERT_EQ(annotated.size(), scans.size());
  int clusters = 0, found = 0;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const std::vector<LegFeature> features = leg_features(ScanView(scans[i]), {});
    for (const Eigen::Vector2d& cluster : annotated[i]) {
      ++clusters;
      if (has_near(features, cluster)) ++found;
    }
  }
  ASSERT_GT(clusters, 100);
  RecordProperty("clusters", clusters);
  RecordProperty("found", found);
  EXPECT_GE(found, 0.85 * clusters);
}

INSTANTIATE_TEST_SUITE_P(Runs, RecordedLegs,
                         ::testing::Values("positive_2", "positive_3", "positive_4", "positive_6"));

// 58 s of an office in which nobody is.
TEST_F(RecordedPeople, NobodyIsFollowedForLongWhereNobodyIs) {
  const std::vector<LaserScan> scans = scans_of("negative_2_right");
  ASSERT_EQ(scans.size(), 434U);
  PeopleFilter filter({}, Rng(1));
  Trajectory standing;  // where the robot is does not matter to how long somebody is followed
  for (const LaserScan& scan : scans) {
    filter.add(scan, {});
    standing.push_back({scan.time, Pose2{}});
  }
  const FilterResult result = filter.result(standing);
  ASSERT_TRUE(result.tracks.has_value());
  double longest = 0.0;  // [s]
  for (const ObjectTrack& track : *result.tracks) {
    longest = std::max(longest, track.states.back().time - track.states.front().time);
  }
  RecordProperty("tracks", static_cast<int>(result.tracks->size()));
  RecordProperty("longest", std::to_string(longest));
  EXPECT_LE(longest, 2.0);
}

}  // namespace
}  // namespace mapbed
