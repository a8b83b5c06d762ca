#include "bench/figures/people_moments.h"

#include <gmock/gmock.h>

#include "algorithms/people/front_end/occlusion.h"
#include "algorithms/people/testing/people_in_a_room.h"
#include "bench/figures/people_figures.h"
#include "bench/figures/range_profile.h"
#include "bench/plot/map_raster.h"
#include "bench/plot/track_style.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

// Nobody for 2 s; then somebody who walks 6 m along y in 6 s, 3 m ahead of the robot. A wall 2 m
// ahead hides him where |y| is less than 0.75 m, from 3.75 s to 5.25 s.
struct Walk {
  std::vector<Eigen::Vector2d> positions;
  FigureLog log;
};

Walk walk_behind_a_wall() {
  Walk result;
  result.positions.assign(20, nowhere());
  walk(result.positions, {3.0, -2.5}, {3.0, 3.5});
  ReplayTrack person{"anna", "person", 0.25, {}};
  for (const LaserScan& scan : scans_of_somebody(result.positions, {{{2.0, -0.5}, {2.0, 0.5}}})) {
    const Eigen::Vector2d& place = result.positions[result.log.truth.size()];
    result.log.log.push_back(Odometry{.time = scan.time});
    result.log.log.push_back(scan);
    result.log.truth.push_back({scan.time, {}});
    if (std::isfinite(place.x()))
      person.world_from_it.push_back({scan.time, {place.x(), place.y(), 0.0}});
  }
  result.log.people = {person};
  return result;
}

class APeopleDrive : public ::testing::Test {
 protected:
  Walk walk_ = walk_behind_a_wall();
  PeopleDrive drive_{walk_.log, {}};
};

TEST_F(APeopleDrive, KnowsItsScansByTheirTimeSinceTheStart) {
  ASSERT_EQ(drive_.scans(), walk_.positions.size());
  EXPECT_EQ(drive_.scan_at(0.0), 0u);
  EXPECT_EQ(drive_.scan_at(4.05), 40u);
  EXPECT_EQ(drive_.scan_at(1000.0), drive_.scans() - 1);
  EXPECT_NEAR(drive_.seconds_at(40), 4.0, 1e-6);
}

TEST_F(APeopleDrive, FindsWhoWasHiddenAndIsFollowedOn) {
  const auto occlusion = drive_.longest_occlusion();
  ASSERT_TRUE(occlusion.has_value());
  EXPECT_NEAR(drive_.seconds_at(occlusion->first), 3.75, 0.3);
  EXPECT_NEAR(drive_.seconds_at(occlusion->last), 5.25, 0.3);
}

TEST_F(APeopleDrive, HasNoOcclusionWhereNobodyIsHidden) {
  Walk open;
  open.positions.assign(20, nowhere());
  walk(open.positions, {3.0, -2.5}, {3.0, 3.5});
  for (const LaserScan& scan : scans_of_somebody(open.positions)) open.log.log.push_back(scan);
  EXPECT_FALSE(PeopleDrive(open.log, {}).longest_occlusion().has_value());
}

TEST_F(APeopleDrive, ShowsSamplesWayAndTruthAtAMoment) {
  const std::vector<PeopleMoment> moments = drive_.moments({34, 45});
  ASSERT_THAT(moments, SizeIs(2));
  for (const std::size_t i : {0u, 1u}) {
    const Eigen::Vector2d& truth = walk_.positions[i == 0 ? 34 : 45];
    ASSERT_THAT(moments[i].people, SizeIs(1));
    const PersonThen& then = moments[i].people[0];
    EXPECT_EQ(then.person.is_seen, i == 0) << "and hidden later";
    EXPECT_LT((then.person.position - truth).norm(), 0.5);
    EXPECT_EQ(then.samples.size(), 200u);
    EXPECT_LT((then.way.back() - then.person.position).norm(), 1e-9);
    EXPECT_GT((then.way.front() - then.way.back()).norm(), 0.5);
    ASSERT_THAT(moments[i].truth, SizeIs(1));
    EXPECT_LT((moments[i].truth[0] - truth).norm(), 0.05);
    const ScanSightings& found = moments[i].found;
    EXPECT_EQ(
        std::any_of(found.features.begin(), found.features.end(),
                    [&](const LegFeature& leg) { return (leg.position - truth).norm() < 0.4; }),
        i == 0);
    EXPECT_LT(hidden_probability(found.view, {1.0, 0.0}, 0.15), 0.5) << "nothing is before it";
    EXPECT_EQ(moments[i].found.places.size(), moments[i].found.features.size());
    ASSERT_TRUE(moments[i].before.has_value());
    EXPECT_NEAR(moments[i].found.time() - moments[i].before->time(), 1.6, 1e-6);
  }
}

TEST_F(APeopleDrive, OfALogWithoutScansIsRefused) {
  const FigureLog empty{.log = {Odometry{.time = 1.0}}};
  EXPECT_THROW(PeopleDrive(empty, {}), InputError);
}

int count_of(const RgbImage& image, const Rgb& color) {
  return static_cast<int>(std::count(image.pixels().begin(), image.pixels().end(), color));
}

class PeopleFigures : public APeopleDrive {
 protected:
  const PeopleFigure& figure(const std::string& name) const {
    for (const PeopleFigure& one : people_figures()) {
      if (one.name == name) return one;
    }
    throw std::out_of_range(name);
  }
  RgbImage drawn(const std::string& name, std::optional<double> at = {}) const {
    return figure_of(figure(name), walk_.log, {}, at, 300);
  }
};

TEST_F(PeopleFigures, AreAllDrawnAtTheirOwnMomentsAndAtTheVeryFirst) {
  for (const PeopleFigure& one : people_figures()) {
    EXPECT_NEAR(drawn(one.name).width(), 300, 100) << one.name;
    EXPECT_GT(drawn(one.name, 0.0).width(), 150) << one.name << ", of one scan";
  }
}

TEST_F(PeopleFigures, ThatShowTrackingGoThroughTheLongestOcclusion) {
  const std::vector<std::size_t> scans = figure("tracking").scans(drive_, {});
  const auto occlusion = *drive_.longest_occlusion();
  ASSERT_THAT(scans, SizeIs(4));
  EXPECT_LT(scans[0], occlusion.first);
  EXPECT_EQ(scans[2], occlusion.last);
  EXPECT_GT(scans[3], occlusion.last);
  EXPECT_THAT(figure("tracking").scans(drive_, 4.0), ElementsAre(22u, 28u, 34u, 40u));
  EXPECT_GT(count_of(drawn("tracking"), track_color(occlusion.id)), 40);
}

TEST_F(PeopleFigures, OfAScanMarkLegs) {
  const RgbImage empty = drawn("scan", 1.5);
  const RgbImage walked = drawn("scan", 3.4);
  EXPECT_GT(count_of(walked, kDynamicColor), count_of(empty, kDynamicColor) + 5);
}

TEST_F(PeopleFigures, OfWhatDiffersMarkWhatMovedOnlyWhereSomebodyWalks) {
  const int in_legend = count_of(drawn("difference", 1.5), kDynamicColor);
  EXPECT_GT(count_of(drawn("difference", 3.4), kDynamicColor), in_legend + 5);
}

TEST_F(PeopleFigures, AreFilesOfARunThatNamesThem) {
  RunInput input;
  input.log = walk_.log.log;
  const std::vector<ResultFile> files = files_of_figures({"tracking", "scan"}, input);
  ASSERT_THAT(files, SizeIs(2));
  EXPECT_EQ(files[0].path, "maps/tracking.png");
  EXPECT_THAT(files[1].title, HasSubstr("Figure 3.1"));
  EXPECT_THAT(files_of_figures({}, RunInput{}), SizeIs(0)) << "also of a log without scans";
  EXPECT_THROW(check_people_figures({"trackin"}), InputError);
  EXPECT_THROW(check_people_figures({"scan", "scan"}), InputError);
  EXPECT_NO_THROW(check_people_figures({"scan", "tracking"}));
}

TEST_F(PeopleFigures, RefuseOptionsAndTimesThatThereAreNot) {
  const auto refusal = [&](const Settings& settings, double at) -> std::string {
    try {
      figure_of(figure("scan"), walk_.log, settings, at, 600);
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_THAT(refusal({{"tracker.particle", "3", {}}}, 1.0), HasSubstr("particles"));
  EXPECT_THAT(refusal({}, 50.0), HasSubstr("--at 50 s is behind the last scan, which is at 7.9 s"));
}

TEST(RangeProfile, MarksTheBeamsOfFeaturesAlone) {
  LaserScan scan{.first_bearing = -1.0, .bearing_step = 0.1, .max_range = 10.0};
  scan.ranges.assign(21, 4.0);
  scan.ranges[10] = 2.0;
  const Rgb mark{255, 0, 0};
  EXPECT_EQ(count_of(range_profile(ScanView(scan), {}, 300, 200, mark), mark), 0);
  LegFeature feature{.first = 10, .last = 10};
  const RgbImage image = range_profile(ScanView(scan), {feature}, 300, 200, mark);
  ASSERT_GT(count_of(image, mark), 0);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (image.at(x, y) != mark) continue;
      EXPECT_NEAR(x, 166, 8) << "straight ahead, in the middle";
    }
  }
}

}  // namespace
}  // namespace mapbed
