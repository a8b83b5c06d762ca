// The metrics of trackers on small recordings whose values follow by hand from their definitions.

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/metrics/clear_mot.h"
#include "bench/metrics/hota.h"
#include "bench/metrics/identity_f1.h"
#include "bench/metrics/occlusions.h"
#include "bench/metrics/ospa.h"
#include "core/random.h"

namespace mapbed {
namespace {

constexpr double kNear = 0.5;  // [m] of a match

TrueObject truth_at(int id, double x, bool counts = true) {
  return {id, {x, 0.0}, counts};
}

TrackedObject track_at(int id, double x) {
  return {id, {x, 0.0}};
}

// One person at 0 for ten frames, of which the given track is there, at `x`, in those from `from`
// to before `to`.
TrackingFrames person_alone() {
  TrackingFrames frames;
  for (int i = 0; i < 10; ++i) frames.push_back({0.1 * i, {truth_at(1, 0.0)}, {}});
  return frames;
}

void add_track(TrackingFrames& frames, int id, double x, int from, int to) {
  for (int i = from; i < to; ++i) {
    frames[static_cast<std::size_t>(i)].tracks.push_back(track_at(id, x));
  }
}

TEST(Matching, MakesAsManyPairsAsPossibleWithinTheDistance) {
  const TrackingFrame frame{
      0.0, {truth_at(1, 0.0), truth_at(2, 0.4)}, {track_at(7, 0.3), track_at(8, 0.85)}};
  const std::vector<MatchedPair> pairs = matched_pairs(frame, kNear);
  ASSERT_EQ(pairs.size(), 2U) << "the nearest pair alone would leave two alone";
  EXPECT_EQ(pairs[0].track, 0U);
  EXPECT_EQ(pairs[1].track, 1U);
}

TEST(Matching, WhoDoesNotCountIsLeftOutWithTheTrackThatFollowsHim) {
  const TrackingFrames frames{
      {0.0, {truth_at(1, 0.0), truth_at(2, 5.0, false)}, {track_at(7, 5.1), track_at(8, 9.0)}}};
  const TrackingFrames kept = counting_alone(frames, kNear);
  ASSERT_EQ(kept.front().truth.size(), 1U);
  ASSERT_EQ(kept.front().tracks.size(), 1U);
  EXPECT_EQ(kept.front().tracks.front().id, 8);
}

TEST(ClearMot, OfAPerfectTrackerIsOne) {
  TrackingFrames frames = person_alone();
  add_track(frames, 7, 0.0, 0, 10);
  const ClearMot mot = clear_mot(frames, kNear);
  EXPECT_EQ(mot.accuracy(), 1.0);
  EXPECT_EQ(mot.precision(), 0.0);
}

TEST(ClearMot, MissesFalseTracksAndSwitchesCountAlike) {
  TrackingFrames frames = person_alone();
  add_track(frames, 7, 0.1, 0, 4);   // then two misses
  add_track(frames, 8, 0.3, 6, 10);  // a switch
  add_track(frames, 9, 4.0, 0, 3);   // three false ones
  const ClearMot mot = clear_mot(frames, kNear);
  EXPECT_EQ(mot.misses(), 2);
  EXPECT_EQ(mot.switches, 1);
  EXPECT_EQ(mot.false_positives, 3);
  EXPECT_NEAR(mot.accuracy(), 1.0 - 6.0 / 10.0, 1e-12);
  EXPECT_NEAR(mot.precision(), (4 * 0.1 + 4 * 0.3) / 8.0, 1e-12);
}

TEST(ClearMot, AMatchHoldsAsLongAsItCanThoughAnotherTrackComesNearer) {
  TrackingFrames frames = person_alone();
  add_track(frames, 7, 0.3, 0, 10);
  add_track(frames, 8, 0.0, 5, 10);
  const ClearMot mot = clear_mot(frames, kNear);
  EXPECT_EQ(mot.switches, 0);
  EXPECT_EQ(mot.false_positives, 5);
}

TEST(ClearMot, OfNobodyIsNoNumber) {
  EXPECT_TRUE(std::isnan(clear_mot({}, kNear).accuracy()));
  EXPECT_TRUE(std::isnan(clear_mot({}, kNear).precision()));
}

TEST(IdentityF1, GivesAPersonTheTrackThatAgreesLongest) {
  TrackingFrames frames = person_alone();
  add_track(frames, 7, 0.0, 0, 4);
  add_track(frames, 8, 0.0, 4, 10);
  EXPECT_NEAR(identity_f1(frames, kNear), 2.0 * 6.0 / (10.0 + 10.0), 1e-12);
}

TEST(IdentityF1, ATrackBelongsToOnePersonOnly) {
  TrackingFrames frames = person_alone();
  for (int i = 0; i < 5; ++i) frames[static_cast<std::size_t>(i)].truth = {truth_at(2, 0.0)};
  add_track(frames, 7, 0.0, 0, 10);
  EXPECT_NEAR(identity_f1(frames, kNear), 2.0 * 5.0 / (10.0 + 10.0), 1e-12);
}

TEST(Hota, OfAPerfectTrackerIsOne) {
  TrackingFrames frames = person_alone();
  add_track(frames, 7, 0.0, 0, 10);
  const Hota h = hota(frames, 1.0);
  EXPECT_NEAR(h.hota, 1.0, 1e-12);
  EXPECT_NEAR(h.association, 1.0, 1e-12);
}

// Detection is perfect; of each of the two tracks 5 of 10 frames are the person's.
TEST(Hota, OfATrackThatIsCutInHalvesIsTheRootOfItsAssociation) {
  TrackingFrames frames = person_alone();
  add_track(frames, 7, 0.0, 0, 5);
  add_track(frames, 8, 0.0, 5, 10);
  const Hota h = hota(frames, 1.0);
  EXPECT_NEAR(h.detection, 1.0, 1e-12);
  EXPECT_NEAR(h.association, 5.0 / (10.0 + 5.0 - 5.0), 1e-12);
  EXPECT_NEAR(h.hota, std::sqrt(0.5), 1e-12);
}

// At 0.4 m the similarity is 0.6: the thresholds 0.05 ... 0.60, 12 of 19, are reached.
TEST(Hota, CountsAMatchAtTheThresholdsThatItsDistanceReaches) {
  TrackingFrames frames = person_alone();
  add_track(frames, 7, 0.4, 0, 10);
  EXPECT_NEAR(hota(frames, 1.0).hota, 12.0 / 19.0, 1e-12);
}

TEST(Hota, OfFalseTracksAloneIsZero) {
  TrackingFrames frames = person_alone();
  for (TrackingFrame& frame : frames) frame.truth.clear();
  add_track(frames, 7, 0.0, 0, 10);
  EXPECT_EQ(hota(frames, 1.0).hota, 0.0);
  EXPECT_TRUE(std::isnan(hota({}, 1.0).hota));
}

TEST(Ospa, IsTheMeanDistanceWithTheCutOffForWhoIsLeftOver) {
  const TrackingFrame frame{0.0,
                            {truth_at(1, 0.0), truth_at(2, 3.0), truth_at(3, 9.0)},
                            {track_at(7, 0.2), track_at(8, 5.0)}};
  EXPECT_NEAR(ospa(frame, 1.0), (0.2 + 1.0 + 1.0) / 3.0, 1e-12);
  EXPECT_EQ(ospa({}, 1.0), 0.0);
}

// The axioms of a metric, on random sets.
TEST(Ospa, IsAMetric) {
  Rng rng(1);
  const auto random_set = [&] {
    std::vector<Eigen::Vector2d> set(rng.index(5));
    for (Eigen::Vector2d& p : set) p = {rng.uniform(0, 2), rng.uniform(0, 2)};
    return set;
  };
  const auto distance = [](const auto& a, const auto& b) {
    TrackingFrame frame;
    for (const Eigen::Vector2d& p : a) frame.truth.push_back({0, p, true});
    for (const Eigen::Vector2d& p : b) frame.tracks.push_back({0, p});
    return ospa(frame, 1.0);
  };
  for (int i = 0; i < 300; ++i) {
    const auto a = random_set(), b = random_set(), c = random_set();
    EXPECT_NEAR(distance(a, b), distance(b, a), 1e-12);
    EXPECT_LE(distance(a, c), distance(a, b) + distance(b, c) + 1e-12);
    EXPECT_EQ(distance(a, a), 0.0);
  }
}

class Occluded : public ::testing::Test {
 protected:
  // Hidden in the frames 3 to 6, [0.3 s, 0.7 s).
  Occluded() : frames_(person_alone()) {
    for (std::size_t i = 3; i < 7; ++i) {
      frames_[i].truth = {{.id = 1, .counts = false, .is_hidden = true}};
    }
  }
  TrackingFrames frames_;
};

TEST_F(Occluded, IsKeptByTheTrackThatWasThereBefore) {
  add_track(frames_, 7, 0.0, 0, 3);
  add_track(frames_, 7, 0.0, 8, 10);
  const Occlusions found = occlusions_in(frames_);
  EXPECT_EQ(found.all, 1);
  EXPECT_EQ(found.kept, 1);
}

TEST_F(Occluded, IsLostToANewTrack) {
  add_track(frames_, 7, 0.0, 0, 3);
  add_track(frames_, 8, 0.0, 7, 10);
  const Occlusions found = occlusions_in(frames_);
  EXPECT_EQ(found.all, 1);
  EXPECT_EQ(found.kept, 0);
}

TEST_F(Occluded, IsNotWhoIsMerelyOutOfReach) {
  for (std::size_t i = 3; i < 7; ++i) frames_[i].truth = {truth_at(1, 0.0, false)};
  add_track(frames_, 7, 0.0, 0, 10);
  EXPECT_EQ(occlusions_in(frames_).all, 0);
}

TEST_F(Occluded, IsNotLookedAtWithoutATrackBeforeNorIfItIsLong) {
  EXPECT_EQ(occlusions_in(frames_).all, 0);
  add_track(frames_, 7, 0.0, 0, 10);
  EXPECT_EQ(occlusions_in(frames_, {.longest = 0.3}).all, 0);
}

}  // namespace
}  // namespace mapbed
