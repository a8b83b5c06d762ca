#include "bench/experiments/people_counts.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/file/atomic_file.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;

constexpr Evidence kWalks{Evidence::Kind::step, SeenBefore::free, Evidence::Left::free, true};
constexpr Evidence kJumps{Evidence::Kind::step, SeenBefore::mixed, Evidence::Left::same, false};
constexpr Evidence kStays{Evidence::Kind::stay, SeenBefore::nothing, {}, true};
constexpr Evidence kMissed{Evidence::Kind::missed, {}, {}, true};

double of(const std::array<double, kEvidences>& counts, const Evidence& evidence) {
  return counts[number_of(evidence)];
}

// Somebody who walks along x at 1 m/s, and somebody at (0, 5) who has stood so far; a second from
// scan to scan.
TrackingFrames truth(int scans) {
  TrackingFrames frames;
  for (int k = 0; k < scans; ++k) {
    frames.push_back(
        {static_cast<double>(k),
         {{.id = 1, .position = {static_cast<double>(k), 0.0}, .counts = true, .has_moved = true},
          {.id = 2, .position = {0.0, 5.0}, .counts = false, .has_moved = false}},
         {}});
  }
  return frames;
}

TEST(PeopleCounts, AreOfWhoWalksWithin40CmAndOfElseBeyond90CmFromEverybody) {
  std::vector<FollowedScan> scans(2);
  scans[0] = {.followed = {1, 2, 3, 4}, .features = 3};
  scans[1].followed = scans[0].followed;
  scans[1].said = {{1, {1.0, 0.39}, kWalks},    // he who walks
                   {2, {1.0, 0.60}, kWalks},    // he or not
                   {3, {1.0, -0.95}, kJumps},   // nobody
                   {4, {0.1, 5.0}, kStays},     // who stands
                   {4, {0.0, 4.05}, kMissed}};  // nobody, near who stands
  scans[1].features = 1;
  const PeopleCounts counts = counted(scans, truth(2), {});
  EXPECT_EQ(of(counts.people, kWalks), 1);
  EXPECT_EQ(counts.of_people(), 1);
  EXPECT_EQ(of(counts.others, kJumps), 1);
  EXPECT_EQ(of(counts.others, kMissed), 1);
  EXPECT_EQ(counts.of_others(), 2);
  // One person in view had walked: once with three features and once with one.
  ASSERT_EQ(counts.scans.size(), 2U);
  EXPECT_THAT(counts.scans[0], ElementsAre());
  EXPECT_THAT(counts.scans[1], ElementsAre(0, 1, 0, 1));
}

TEST(PeopleCounts, AreOfTheFirstFourSecondsOfATrack) {
  std::vector<FollowedScan> scans(7);
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const Eigen::Vector2d him(static_cast<double>(k), 0.0);
    if (k >= 1) scans[k].followed = {8};
    if (k >= 2) scans[k].said = {{8, him, kWalks}};  // 1, 2, 3, 4 and 5 s after it was taken up
  }
  EXPECT_EQ(counted(scans, truth(7), {}).of_people(), 4);
}

TEST(PeopleCounts, OfDrivesAddUp) {
  PeopleCounts sum;
  sum.add_scan(0, 2);
  PeopleCounts more;
  more.add_scan(0, 2);
  more.add_scan(2, 3);
  more.people[3] = 5;
  sum.add(more);
  EXPECT_THAT(sum.scans, ElementsAre(ElementsAre(0, 0, 2), ElementsAre(), ElementsAre(0, 0, 0, 1)));
  EXPECT_EQ(sum.people[3], 5);
  EXPECT_EQ(sum.of_scans(), 3);
}

TEST(PeopleCounts, EveryEvidenceHasANumberOfItsOwnAndAPlaceInTheFile) {
  EXPECT_EQ(number_of({Evidence::Kind::step, SeenBefore::nothing, Evidence::Left::nowhere, true}),
            0U);
  EXPECT_EQ(number_of({Evidence::Kind::step, SeenBefore::same, Evidence::Left::same, false}), 31U);
  EXPECT_EQ(number_of(kMissed), 36U);
  EXPECT_EQ(place_of_evidence(number_of(kWalks)),
            std::make_pair(std::string("steady_step.free"), std::size_t{2}));
  EXPECT_EQ(place_of_evidence(number_of(kJumps)),
            std::make_pair(std::string("unsteady_step.mixed"), std::size_t{3}));
  EXPECT_EQ(place_of_evidence(35), std::make_pair(std::string("stay"), std::size_t{3}));
}

// 100 evidences of people and 300 of others; counted besides 2 times, 0.5 and 1.5 of them.
PeopleCounts counts_by_hand() {
  PeopleCounts counts;
  counts.people[number_of(kWalks)] = 80;
  counts.others[number_of(kWalks)] = 10;
  counts.people[number_of(kStays)] = 20;
  counts.others[number_of(kStays)] = 290;
  counts.scans = {{5, 1}, {0, 4}};
  return counts;
}

TEST(LearnedPeopleFromCounts, AreRatiosOfHowOftenEachIsSaid) {
  const LearnedPeople learned = learned_from(counts_by_hand(), {.least_seen = 2.0});
  EXPECT_NEAR(learned.log_ratio(kWalks), std::log((80.5 / 100) / (11.5 / 300)), 0.005 + 1e-9);
  EXPECT_NEAR(learned.log_ratio(kStays), std::log((20.5 / 100) / (291.5 / 300)), 0.005 + 1e-9);
  EXPECT_EQ(learned.log_ratio(kMissed), 0.0) << "nobody knows";
  EXPECT_THAT(learned.scans[0], ElementsAre(5, 1));
}

TEST(LearnedPeopleFromCounts, AreAFileThatIsReadAgain) {
  const TemporaryFolder folder;
  const PeopleCounts counts = counts_by_hand();
  const LearnedPeople learned = learned_from(counts, {});
  const std::string yaml = learned_yaml(learned, counts);
  EXPECT_THAT(yaml, ::testing::HasSubstr("of people 0 0 80 0, of else 0 0 10 0"));
  write_file(folder.file("p.yaml"), yaml);
  const LearnedPeople again = load_learned_people(folder.file("p.yaml"));
  EXPECT_EQ(again.steady_step, learned.steady_step);
  EXPECT_EQ(again.stay, learned.stay);
  EXPECT_EQ(again.scans, learned.scans);
}

TEST(LearnedPeopleFromCounts, LoseWhatTheirProbabilitiesSay) {
  PeopleCounts counts;
  counts.people[number_of(kMissed)] = 1;
  counts.others[number_of(kMissed)] = 3;
  counts.scans = {{2}, {0, 1}};
  LearnedPeople learned = learned_from(counts_by_hand(), {});
  EXPECT_NEAR(evidence_loss(counts, learned), std::log(2.0), 1e-12) << "it says nothing";
  learned.missed = std::log(3.0);  // p = 3/4 that it is a person
  EXPECT_NEAR(evidence_loss(counts, learned), -0.5 * (std::log(0.75) + std::log(0.25)), 1e-12);
  const FeatureNumbers numbers({{0.5, 0.5}, {0.2, 0.8}});
  EXPECT_NEAR(number_loss(counts, numbers), -(2 * std::log(0.5) + std::log(0.8)) / 3, 1e-12);
}

TEST(LearnedPeopleFromCounts, DifferByTheErrorOfCounting) {
  const PeopleCounts counts = counts_by_hand();
  const LearnedPeople learned = learned_from(counts, {});
  EXPECT_EQ(difference_by_error(learned, learned, counts), 0.0);
  LearnedPeople file = learned;
  const double error = std::sqrt(1.0 / 80 + 1.0 / 10 + 0.01 / 12);
  file.steady_step[1][2] += 2 * error;
  EXPECT_NEAR(difference_by_error(file, learned, counts), std::sqrt(4.0 / 2), 1e-9);
}

}  // namespace
}  // namespace mapbed
