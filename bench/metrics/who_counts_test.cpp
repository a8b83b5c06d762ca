#include "bench/metrics/who_counts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/actors/person_body.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;

// One person who is at the places in turn, a frame every second; NaN: hidden there.
TrackingFrames walk(const std::vector<double>& places, std::vector<bool> in_view = {}) {
  in_view.resize(places.size(), true);
  TrackingFrames frames;
  for (std::size_t i = 0; i < places.size(); ++i) {
    frames.push_back({static_cast<double>(i),
                      {{.id = 7, .position = {places[i], 0.0}, .counts = in_view[i]}},
                      {}});
  }
  return frames;
}

std::vector<bool> counting(const TrackingFrames& frames) {
  std::vector<bool> result;
  for (const TrackingFrame& frame : frames) result.push_back(frame.truth[0].counts);
  return result;
}

TEST(ByAppearance, CountsNobodyBeforeHeFirstWalks) {
  const TrackingFrames frames = by_appearance(walk({1.0, 1.1, 2.0, 2.0, 1.0}), {});
  EXPECT_THAT(counting(frames), ElementsAre(false, false, true, true, true));
}

TEST(ByAppearance, TellsWhoHasWalkedAlsoWhileHeIsHidden) {
  const TrackingFrames frames = by_appearance(walk({1.0, 2.0, 3.0}, {true, true, false}), {});
  EXPECT_THAT(counting(frames), ElementsAre(false, true, false));
  std::vector<bool> has_moved;
  for (const TrackingFrame& frame : frames) has_moved.push_back(frame.truth[0].has_moved);
  EXPECT_THAT(has_moved, ElementsAre(false, true, true));
}

TEST(ByAppearance, NumbersAnewWhoWasAwayForLong) {
  const std::vector<bool> in_view{true, true, false, false, true, false, false, false, true, true};
  const TrackingFrames frames =
      by_appearance(walk({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, in_view), {.longest_absence = 3.0});
  EXPECT_EQ(frames[1].truth[0].id, frames[4].truth[0].id);
  EXPECT_NE(frames[4].truth[0].id, frames[8].truth[0].id);
  EXPECT_THAT(counting(frames),
              ElementsAre(false, true, false, false, true, false, false, false, false, true));
}

TEST(PeopleAt, KeepsWhoIsTooFarAndWhoIsHiddenWithoutAskingForThem) {
  Truth truth;
  truth.entities = {{.id = 0, .name = "near", .kind = EntityKind::person, .parts = {}},
                    {.id = 1, .name = "hidden", .kind = EntityKind::person, .parts = {}},
                    {.id = 2, .name = "far", .kind = EntityKind::person, .parts = {}},
                    {.id = 3, .name = "behind", .kind = EntityKind::person, .parts = {}}};
  StampedStates states;
  states.time = 5.0;
  for (int id = 0; id < 4; ++id) {
    MovingPose trunk;
    trunk.entity = id;
    trunk.part = kTrunk;
    trunk.world_from_part.position = {id == 3 ? -2.0 : id == 2 ? 10.0 : 2.0, 0.5 * id, 1.2};
    states.moving.push_back(trunk);
  }
  const auto on = [](int entity) { return BeamTruth{.entity = entity}; };
  truth.beams = {{.time = 5.0, .laser = 0, .beams = {on(0), on(0), on(1), on(2), on(2)}}};
  LaserScan scan;
  scan.time = 5.0;
  scan.ranges.assign(5, 2.0);
  scan.first_bearing = -1.0;
  scan.bearing_step = 0.5;
  const std::vector<TrueObject> people =
      people_at(scan, states, truth, {.range = 8.0, .least_beams = 2});
  ASSERT_EQ(people.size(), 4U);
  EXPECT_TRUE(people[0].counts);
  EXPECT_FALSE(people[1].counts);
  EXPECT_TRUE(people[1].is_hidden);
  EXPECT_FALSE(people[2].counts);
  EXPECT_FALSE(people[2].is_hidden);
  EXPECT_FALSE(people[3].is_hidden) << "nothing looks behind";
}

}  // namespace
}  // namespace mapbed
