#include "algorithms/people/tracking_filter.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/people/leg_filter.h"
#include "algorithms/people/testing/people_in_a_room.h"

namespace mapbed {
namespace {

using ::testing::Each;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

struct Filtered {
  FilterResult result;
  std::vector<std::vector<float>> weights;
};

// With odometry of a robot that stands.
Filtered filtered(BeamFilter& filter, const std::vector<LaserScan>& scans) {
  Filtered all;
  Trajectory path;
  for (const LaserScan& scan : scans) {
    filter.add(Odometry{.time = scan.time});
    all.weights.push_back(filter.add(scan, {}));
    path.push_back({scan.time, {}});
  }
  all.result = filter.result(path);
  return all;
}

template <class Filter>
Filtered filtered(const std::vector<LaserScan>& scans,
                  const typename Filter::Options& options = {}) {
  Filter filter(options, Rng(7));
  return filtered(filter, scans);
}

// Beams that end on somebody, and how many of them are labelled so.
struct Count {
  int beams = 0;
  int dynamic = 0;
};
Count on_somebody(const Filtered& all, const std::vector<LaserScan>& scans,
                  const std::vector<Eigen::Vector2d>& positions, std::size_t from, std::size_t to) {
  Count count;
  for (std::size_t k = from; k < to; ++k) {
    for (std::size_t b = 0; b < scans[k].ranges.size(); ++b) {
      const Eigen::Vector2d end = scans[k].point_on(b, scans[k].ranges[b]);
      if ((end - positions[k]).norm() > 0.25) continue;
      ++count.beams;
      if (is_dynamic(all.result.labels[k], b)) ++count.dynamic;
    }
  }
  return count;
}

int dynamic_beams(const BeamLabels& labels) {
  int count = 0;
  for (const ScanLabels& scan : labels) {
    for (std::size_t b = 0; b < scan.static_probability.size(); ++b) {
      count += is_dynamic(scan, b) ? 1 : 0;
    }
  }
  return count;
}

// Nobody for two seconds, then somebody who walks through.
std::vector<Eigen::Vector2d> somebody_walks() {
  std::vector<Eigen::Vector2d> positions(20, nowhere());
  walk(positions, {3.0, -2.5}, {3.0, 3.5});
  return positions;
}

template <class Filter>
class ATracker : public ::testing::Test {};
using Trackers = ::testing::Types<PeopleFilter, KalmanPeopleFilter>;
TYPED_TEST_SUITE(ATracker, Trackers);

TYPED_TEST(ATracker, FollowsWhoWalksFromFirstToLastUnderOneNumber) {
  const std::vector<Eigen::Vector2d> positions = somebody_walks();
  const std::vector<LaserScan> scans = scans_of_somebody(positions);
  const Filtered all = filtered<TypeParam>(scans);
  ASSERT_THAT(*all.result.tracks, SizeIs(1));
  const ObjectTrack& track = all.result.tracks->front();
  EXPECT_GE(track.states.size(), 50U);  // of 60 scans, a few until the filter begins
  for (const TrackState& state : track.states) {
    const auto k = static_cast<std::size_t>(std::lround((state.time - 100.0) / kScanPeriod));
    EXPECT_LT((state.position - positions[k]).norm(), 0.25);
  }
  EXPECT_NEAR(track.states[40].velocity.y(), 1.0, 0.35);
  const Count count = on_somebody(all, scans, positions, 20, scans.size());
  EXPECT_GT(count.dynamic, 0.97 * count.beams);
  // His boxes hold nobody else: the column and the walls stay.
  EXPECT_LE(dynamic_beams(all.result.labels), count.beams + 40);
}

TYPED_TEST(ATracker, LeavesOutHisBeamsOnline) {
  const std::vector<Eigen::Vector2d> positions = somebody_walks();
  const std::vector<LaserScan> scans = scans_of_somebody(positions);
  const Filtered all = filtered<TypeParam>(scans);
  const std::size_t k = 60;
  for (std::size_t b = 0; b < scans[k].ranges.size(); ++b) {
    const Eigen::Vector2d end = scans[k].point_on(b, scans[k].ranges[b]);
    const double away = (end - positions[k]).norm();
    if (away < 0.2 || away > 2.0) {
      EXPECT_EQ(all.weights[k][b], away < 0.2 ? 0.0F : 1.0F);
    }
  }
}

TYPED_TEST(ATracker, KeepsWhoStops) {
  std::vector<Eigen::Vector2d> positions(20, nowhere());
  walk(positions, {3.0, -2.5}, {3.0, 0.5});
  positions.insert(positions.end(), 100, Eigen::Vector2d(3.0, 0.5));
  const std::vector<LaserScan> scans = scans_of_somebody(positions);
  const Filtered all = filtered<TypeParam>(scans);
  ASSERT_THAT(*all.result.tracks, SizeIs(1));
  EXPECT_NEAR(all.result.tracks->front().states.back().time, scans.back().time, 0.5);
}

// The wall at x = 6 is in his boxes all the way.
TYPED_TEST(ATracker, LeavesTheWallThatHeWalksAlong) {
  std::vector<Eigen::Vector2d> positions(20, nowhere());
  walk(positions, {5.7, -2.5}, {5.7, 3.5});
  const std::vector<LaserScan> scans = scans_of_somebody(positions);
  const auto on_wall = [&](const Filtered& all) {
    int count = 0;
    for (std::size_t k = 0; k < scans.size(); ++k) {
      for (std::size_t b = 0; b < scans[k].ranges.size(); ++b) {
        if (!is_dynamic(all.result.labels[k], b)) continue;
        count += scans[k].point_on(b, scans[k].ranges[b]).x() > 5.95 ? 1 : 0;
      }
    }
    return count;
  };
  const Filtered all = filtered<TypeParam>(scans);
  EXPECT_EQ(on_wall(all), 0);
  const Count count = on_somebody(all, scans, positions, 20, scans.size());
  EXPECT_GT(count.dynamic, 0.9 * count.beams);
  EXPECT_GT(on_wall(filtered<TypeParam>(scans, {.labels = {.keep_place = false}})), 100);
}

TYPED_TEST(ATracker, LabelsWhoStoodThereBeforeHeWent) {
  std::vector<Eigen::Vector2d> positions(60, Eigen::Vector2d(3.0, 0.5));
  walk(positions, {3.0, 0.5}, {3.0, 4.0});
  const std::vector<LaserScan> scans = scans_of_somebody(positions);
  const Count back = on_somebody(filtered<TypeParam>(scans), scans, positions, 0, 60);
  EXPECT_GT(back.dynamic, 0.95 * back.beams);
  const Count not_back =
      on_somebody(filtered<TypeParam>(scans, {.follow_back = false}), scans, positions, 0, 40);
  EXPECT_LT(not_back.dynamic, 0.5 * not_back.beams) << "the test tests something";
}

TYPED_TEST(ATracker, IsThereAgainBehindWhatHidHim) {
  const std::vector<Eigen::Vector2d> positions = somebody_walks();
  // Hides the way from (3, -0.6) to (3, 0.6), more than a second of it.
  const Filtered all =
      filtered<TypeParam>(scans_of_somebody(positions, {{{1.5, -0.3}, {1.5, 0.3}}}));
  ASSERT_THAT(*all.result.tracks, SizeIs(1));
  bool was_hidden = false;
  for (const TrackState& state : all.result.tracks->front().states) {
    was_hidden = was_hidden || state.occluded;
  }
  EXPECT_TRUE(was_hidden);
}

TYPED_TEST(ATracker, OfAnEmptyRoomSaysSo) {
  const Filtered all = filtered<TypeParam>(scans_of_somebody(std::vector(60, nowhere())));
  EXPECT_THAT(*all.result.tracks, IsEmpty());
  EXPECT_EQ(dynamic_beams(all.result.labels), 0);
  for (const std::vector<float>& weights : all.weights) EXPECT_THAT(weights, Each(1.0F));
  ASSERT_FALSE(all.result.remarks.empty());
  EXPECT_EQ(all.result.remarks[0].text, "people: nobody was seen to move");
}

TYPED_TEST(ATracker, TakesScansThatSayNothing) {
  std::vector<LaserScan> scans = scans_of_somebody(somebody_walks());
  for (double& range : scans[30].ranges) range = 0.0;
  for (double& range : scans[31].ranges) range = scans[31].max_range;
  scans[32].ranges.clear();
  scans[33].time = scans[32].time;
  const Filtered all = filtered<TypeParam>(scans);
  ASSERT_THAT(all.result.labels, SizeIs(scans.size()));
  for (const ObjectTrack& track : *all.result.tracks) {
    for (const TrackState& state : track.states) EXPECT_TRUE(state.position.allFinite());
  }
}

// Whatever a tracker is given, it says of each scan something finite.
void expect_sound(const Filtered& all, const std::vector<LaserScan>& scans) {
  ASSERT_EQ(all.result.labels.size(), scans.size());
  for (std::size_t k = 0; k < scans.size(); ++k) {
    ASSERT_EQ(all.result.labels[k].static_probability.size(), scans[k].ranges.size());
    ASSERT_EQ(all.weights[k].size(), scans[k].ranges.size());
    for (const float weight : all.weights[k]) EXPECT_TRUE(weight >= 0.0F && weight <= 1.0F);
  }
  for (const ObjectTrack& track : *all.result.tracks) {
    for (const TrackState& state : track.states) {
      EXPECT_TRUE(state.position.allFinite() && state.velocity.allFinite() &&
                  state.covariance.allFinite());
    }
  }
  ASSERT_FALSE(all.result.remarks.empty());
}

TYPED_TEST(ATracker, TakesScansOfPeopleAlone) {
  // Twelve in a ring who close in on the robot; no wall is in reach.
  std::vector<LaserScan> scans;
  for (int k = 0; k < 18; ++k) {
    TestRoom room = rectangular_room(80.0, 80.0);
    for (int i = 0; i < 12; ++i) {
      const double angle = radians(30.0 * i);
      add_person(room, (4.0 - 0.1 * k) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    scans.push_back(scan_of(room, {}, round_laser(), 100.0 + kScanPeriod * k));
  }
  const Filtered all = filtered<TypeParam>(scans);
  expect_sound(all, scans);
  EXPECT_THAT(*all.result.tracks, Not(IsEmpty()));
}

TYPED_TEST(ATracker, TakesARobotThatIsBlockedAllAround) {
  std::vector<LaserScan> scans;
  for (int k = 0; k < 30; ++k) {
    TestRoom room = rectangular_room(12.0, 10.0);
    for (int i = 0; i < 12; ++i) {
      const double angle = radians(30.0 * i);
      add_leg(room, 0.6 * Eigen::Vector2d(std::cos(angle), std::sin(angle)), 0.12);
    }
    scans.push_back(scan_of(room, {}, round_laser(), 100.0 + kScanPeriod * k));
  }
  const Filtered all = filtered<TypeParam>(scans);
  expect_sound(all, scans);
  EXPECT_THAT(*all.result.tracks, IsEmpty());
}

TYPED_TEST(ATracker, NeedsNoOdometry) {
  std::vector<LaserScan> scans = scans_of_somebody(somebody_walks());
  scans.resize(50);
  TypeParam filter({}, Rng(7));
  Filtered all;
  Trajectory path;
  for (const LaserScan& scan : scans) {
    all.weights.push_back(filter.add(scan, {}));
    path.push_back({scan.time, {}});
  }
  all.result = filter.result(path);
  expect_sound(all, scans);
  EXPECT_THAT(*all.result.tracks, SizeIs(1));
  EXPECT_THAT(all.result.remarks[0].text, ::testing::StartsWith("people: 1 track of "));
}

TYPED_TEST(ATracker, TakesScansWithoutBeamsAndOfOneMoment) {
  std::vector<LaserScan> scans = scans_of_somebody(somebody_walks());
  scans.resize(40);
  scans[0].ranges.clear();
  for (std::size_t k = 25; k < 30; ++k) scans[k].time = scans[24].time;
  for (std::size_t k = 33; k < 40; ++k) scans[k].ranges.clear();
  expect_sound(filtered<TypeParam>(scans), scans);
  for (LaserScan& scan : scans) scan.ranges.clear();
  const Filtered nothing = filtered<TypeParam>(scans);
  expect_sound(nothing, scans);
  EXPECT_EQ(nothing.result.remarks[0].text, "people: nobody was seen to move");
}

TEST(TrackingFilter, TakesAnyNumberOfFiltersAndPeople) {
  std::vector<LaserScan> scans = scans_of_somebody(somebody_walks());
  scans.resize(50);
  for (const int filters : {1, 10'000}) {
    for (const int people : {1, 200}) {
      PeopleFilter::Options options;
      options.follow_back = false;
      options.tracker.max_filters = filters;
      options.tracker.max_people = people;
      const Filtered all = filtered<PeopleFilter>(scans, options);
      expect_sound(all, scans);
      EXPECT_THAT(*all.result.tracks, SizeIs(1));
    }
  }
}

TEST(TrackHistory, KeepsNothingOfWhatNeverCounted) {
  TrackHistory history;
  FollowedPerson person;
  person.is_confirmed = true;
  FollowedPerson other;
  other.id = 1;
  for (std::size_t k = 0; k < 10; ++k) history.add(k, {person, other});
  EXPECT_EQ(history.states(), 20U);
  history.add(10, {person});
  EXPECT_EQ(history.states(), 11U);
}

TEST(TrackingFilter, IsTheSameOfTheSameSeed) {
  const std::vector<LaserScan> scans = scans_of_somebody(somebody_walks());
  const Tracks a = *filtered<PeopleFilter>(scans).result.tracks;
  const Tracks b = *filtered<PeopleFilter>(scans).result.tracks;
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(a[0].states.back().position, b[0].states.back().position);
}

TEST(TrackingFilter, CarriesTracksWithTheRobotIntoTheMap) {
  const std::vector<LaserScan> scans = scans_of_somebody(somebody_walks());
  PeopleFilter filter({}, Rng(7));
  Trajectory path;
  for (const LaserScan& scan : scans) {
    filter.add(Odometry{.time = scan.time});
    filter.add(scan, {});
    path.push_back({scan.time, {10.0, 5.0, kPi / 2}});
  }
  const Tracks there = *filter.result(path).tracks;
  const Tracks here = *filtered<PeopleFilter>(scans).result.tracks;
  ASSERT_THAT(there, SizeIs(1));
  const Pose2 map_from_local = path[0].pose;
  EXPECT_LT((there[0].states[9].position - map_from_local * here[0].states[9].position).norm(),
            1e-6);
  EXPECT_NEAR(there[0].states[9].velocity.x(), -here[0].states[9].velocity.y(), 1e-6);
}

TEST(LegFilter, LeavesOutLegsThatMovedAndNothingElse) {
  const std::vector<Eigen::Vector2d> positions = somebody_walks();
  const std::vector<LaserScan> scans = scans_of_somebody(positions);
  LegFilter filter({});
  const Filtered all = filtered(filter, scans);
  const Count count = on_somebody(all, scans, positions, 20, scans.size());
  EXPECT_GT(count.dynamic, 0.8 * count.beams);
  EXPECT_LE(dynamic_beams(all.result.labels), count.dynamic + 10);
  EXPECT_FALSE(all.result.tracks.has_value());
}

}  // namespace
}  // namespace mapbed
