#include "algorithms/people/front_end/moved_features.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/people/front_end/sightings.h"
#include "algorithms/people/testing/people_in_a_room.h"

namespace mapbed {
namespace {

using ::testing::SizeIs;

constexpr double kRadius = 0.07;

// Of three past scans.
const PastScans kPast{.times = {0.0, 0.5, 1.0}, .old = 0b111, .least_free = 2};
constexpr PlaceBefore kFree{.free = 0b111};
constexpr PlaceBefore kSame{.same = 0b111};

LaserScan scan_with(const std::vector<Eigen::Vector2d>& legs, double time, const Pose2& pose = {}) {
  TestRoom room = rectangular_room(12.0, 10.0);
  for (const Eigen::Vector2d& leg : legs) add_leg(room, leg);
  return scan_of(room, pose, round_laser(), time);
}

// Past scans with legs at places, and what they say of a feature at one.
SeenBefore seen(const std::vector<std::vector<Eigen::Vector2d>>& past, const Eigen::Vector2d& now) {
  RecentScans recent(RecentScansOptions{});
  double time = 0.0;
  for (const std::vector<Eigen::Vector2d>& legs : past) {
    ScanView view(scan_with(legs, time));
    const std::size_t beams = view.scan().ranges.size();
    recent.add(std::move(view), {}, std::vector<bool>(beams, false));
    time += 0.5;
  }
  const std::vector<LegFeature> features = leg_features(ScanView(scan_with({now}, time)), {});
  EXPECT_THAT(features, SizeIs(1));
  return recent.past(time).verdict(recent.before(features[0], {}, kRadius));
}

TEST(RecentScans, TellWhatMovedFromWhatStoodThere) {
  const Eigen::Vector2d here(3.0, 1.0);
  EXPECT_EQ(seen({{}, {}, {}}, here), SeenBefore::free);
  EXPECT_EQ(seen({{here}, {here}, {here}}, here), SeenBefore::same);
  EXPECT_EQ(seen({{{4.0, 1.0}}, {{3.5, 1.0}}, {{3.3, 0.5}}}, here), SeenBefore::free);
}

TEST(RecentScans, KnowNothingOfWhatWasHidden) {
  EXPECT_EQ(seen({{{1.5, 0.5}}, {{1.5, 0.5}}, {{1.5, 0.5}}}, {3.0, 1.0}), SeenBefore::nothing);
  EXPECT_EQ(seen({}, {3.0, 1.0}), SeenBefore::nothing);
}

TEST(RecentScans, TellWhatIsSeenAtTimesFromWhatMoved) {
  const Eigen::Vector2d here(3.0, 1.0);
  EXPECT_EQ(seen({{}, {here}, {}, {}, {}}, here), SeenBefore::mixed);
  EXPECT_EQ(seen({{here}, {here}, {here}, {here}, {}}, here), SeenBefore::same);
}

TEST(PastScans, LeaveOutWhatIsNotAsked) {
  const PastScans past{.times = {0.0, 0.5, 1.0, 1.5, 2.0}, .old = 0b00111, .least_free = 2};
  const PlaceBefore place{.free = 0b00011, .same = 0b11100};
  EXPECT_EQ(past.verdict(place), SeenBefore::mixed);
  EXPECT_EQ(past.verdict(place, 0b11100), SeenBefore::free);
  EXPECT_EQ(past.verdict(place, 0b00011), SeenBefore::same);
  EXPECT_EQ(past.verdict(place, 0b11111), SeenBefore::nothing);
}

TEST(RecentScans, BeamsOnPeopleSayNothingOfThePlace) {
  RecentScans recent(RecentScansOptions{});
  const Eigen::Vector2d here(3.0, 1.0);
  for (int k = 0; k < 4; ++k) {
    ScanView view(scan_with({here}, 0.5 * k));
    std::vector<bool> on_people;
    for (const double range : view.scan().ranges) on_people.push_back(range < 3.3);
    recent.add(std::move(view), {}, std::move(on_people));
  }
  const std::vector<LegFeature> features = leg_features(ScanView(scan_with({here}, 2.0)), {});
  ASSERT_THAT(features, SizeIs(1));
  EXPECT_EQ(recent.past(2.0).verdict(recent.before(features[0], {}, kRadius)), SeenBefore::nothing);
}

TEST(RecentScans, APartOfTheRobotDidNotMoveThoughItsPlaceIsNew) {
  RecentScans recent(RecentScansOptions{});
  const Eigen::Vector2d part(0.9, 0.3);  // in the robot's frame
  std::vector<LegFeature> features;
  for (int k = 0; k < 6; ++k) {
    const Pose2 pose{0.5 * k - 2.0, 0.0, 0.0};
    const ScanView view(scan_with({pose * part}, 0.5 * k, pose));
    features = leg_features(view, {});
    ASSERT_THAT(features, SizeIs(1));
    if (k == 5) {
      EXPECT_EQ(recent.past(2.5).verdict(recent.before(features[0], pose, kRadius)),
                SeenBefore::same);
    }
    recent.add(view, pose, std::vector<bool>(view.scan().ranges.size(), false));
  }
}

TEST(Sightings, LegsThatAreEachOthersNearestAreOnePerson) {
  const std::vector<LegFeature> features =
      leg_features(ScanView(scan_with({{3.0, 0.15}, {3.0, -0.15}, {3.0, 1.5}}, 0.0)), {});
  ASSERT_THAT(features, SizeIs(3));
  const Pose2 local_from_robot{1.0, 0.0, 0.0};
  const std::vector<Sighting> sightings =
      sightings_of(features, std::vector<PlaceBefore>(3, kFree), kPast, local_from_robot, {});
  ASSERT_THAT(sightings, SizeIs(2));
  EXPECT_THAT(sightings[0].features, SizeIs(2));
  EXPECT_LT((sightings[0].position - Eigen::Vector2d(4.0, 0.0)).norm(), 0.05);
  EXPECT_LT(sightings[0].sigma, sightings[1].sigma);
}

TEST(Sightings, AColumnBesideALegIsNotThePersonsOther) {
  const std::vector<LegFeature> features =
      leg_features(ScanView(scan_with({{3.0, 0.15}, {3.0, -0.15}}, 0.0)), {});
  ASSERT_THAT(features, SizeIs(2));
  EXPECT_THAT(sightings_of(features, {kFree, kSame}, kPast, {}, {}), SizeIs(2));
}

}  // namespace
}  // namespace mapbed
