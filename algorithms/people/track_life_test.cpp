#include "algorithms/people/track_life.h"

#include <cmath>

#include <gtest/gtest.h>

#include "algorithms/people/testing/people_in_a_room.h"

namespace mapbed {
namespace {

// Scans of an empty room, in which somebody is sighted as told; none of the past ones told
// anything.
class Life : public ::testing::Test {
 protected:
  Life() : life_(0, 0.0, at(0.0), options_) {}

  static Eigen::Vector2d at(double y) { return {3.0, y}; }

  // `free`, `same`: what three past scans saw where he is.
  void sight(double time, double y, ScanBits free, ScanBits same) {
    const TestRoom room = rectangular_room(12.0, 10.0);
    ScanSightings scan{ScanView(scan_of(room, {}, round_laser(), time)), {}, {}, {}, {}, {}};
    scan.past = {.times = {-9.0, -8.5, -8.0}, .old = 0b111, .least_free = 2};
    const Sighting sighting{.position = at(y),
                            .sigma = 0.1,
                            .quality = 1.0,
                            .before = SeenBefore::nothing,
                            .place = {.free = free, .same = same},
                            .features = {}};
    life_.recall(scan.past);
    life_.update(scan, &sighting, 0.0, sighting.position, options_, learned_);
  }
  void miss(double time, double y, double hidden) {
    const TestRoom room = rectangular_room(12.0, 10.0);
    const ScanSightings scan{ScanView(scan_of(room, {}, round_laser(), time)), {}, {}, {}, {}, {}};
    life_.update(scan, nullptr, hidden, at(y), options_, learned_);
  }
  void walk(double from, double until, ScanBits free, ScanBits same) {
    for (double t = from; t < until; t += 0.1) sight(t, t, free, same);
  }

  TrackLifeOptions options_;
  LearnedPeople learned_ = load_learned_people("corridor_and_museum");
  TrackLife life_;
};

TEST_F(Life, WhoWalksWhereItWasFreeIsAPersonWithinTwoSeconds) {
  walk(0.1, 2.0, 0b111, 0);
  EXPECT_TRUE(life_.is_confirmed());
}

TEST_F(Life, WhoWalksWhereNobodyLookedBeforeIsAPersonToo) {
  walk(0.1, 4.0, 0, 0);
  EXPECT_TRUE(life_.is_confirmed()) << "nothing is any more where he was";
}

TEST_F(Life, WhatStaysWhereItIsIsNobodyHoweverFreeItWas) {
  for (double t = 0.1; t < 10.0; t += 0.1) sight(t, 0.0, 0b111, 0);
  EXPECT_FALSE(life_.is_confirmed());
}

TEST_F(Life, WhatComesToPlacesWhereSomethingStoodIsGivenUp) {
  walk(0.1, 2.0, 0, 0b111);
  EXPECT_FALSE(life_.is_confirmed());
  EXPECT_TRUE(life_.is_over(2.0, 0.1, options_));
}

TEST_F(Life, WhoWalkedOnceStaysAPersonWhileHeStands) {
  walk(0.1, 2.0, 0b111, 0);
  for (double t = 2.0; t < 60.0; t += 0.1) sight(t, 2.0, 0, 0);
  EXPECT_TRUE(life_.is_confirmed());
  EXPECT_FALSE(life_.is_over(60.0, 0.1, options_));
}

TEST_F(Life, WhoIsHiddenIsKeptLongerThanWhoShouldBeSeen) {
  walk(0.1, 2.0, 0b111, 0);
  TrackLife in_view = life_;
  for (double t = 2.0; t < 3.5; t += 0.1) miss(t, t, 1.0);
  EXPECT_FALSE(life_.is_over(3.5, 0.1, options_));
  life_ = in_view;
  for (double t = 2.0; t < 3.5; t += 0.1) miss(t, t, 0.0);
  EXPECT_TRUE(life_.is_over(3.5, 0.1, options_));
}

TEST_F(Life, HeHimselfIsNotWhatStoodThereBefore) {
  for (double t = 0.1; t < 1.5; t += 0.1) sight(t, 0.0, 0, 0);
  const PastScans past{.times = {0.2, 0.6, 1.0}, .old = 0b111, .least_free = 2};
  life_.recall(past);
  Sighting here;
  here.position = at(0.1);
  here.place.same = 0b111;
  EXPECT_EQ(life_.before(past, here), SeenBefore::nothing);
  here.position = at(1.0);
  EXPECT_EQ(life_.before(past, here), SeenBefore::same);
}

}  // namespace
}  // namespace mapbed
