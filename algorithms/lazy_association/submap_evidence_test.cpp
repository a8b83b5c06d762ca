#include "algorithms/lazy_association/submap_evidence.h"

#include <gtest/gtest.h>

#include "algorithms/testing/furnished_room.h"

namespace mapbed {
namespace {

const TestLaser kLaser{.beams = 360, .first_bearing = -kPi, .max_range = 10.0};

Submap submap_at(const TestRoom& room, const Pose2& map_from_submap) {
  std::vector<SubmapScan> scans;
  for (int i = -2; i <= 2; ++i) {
    const Pose2 submap_from_robot{0.4 * i, 0.0, 0.0};
    const LaserScan scan = scan_of(room, map_from_submap * submap_from_robot, kLaser);
    scans.push_back(
        {submap_from_robot, surface_points(scan, 30.0, 0.2, 0.1), ScanExtent(scan, 30.0, 20.0)});
  }
  return make_submap(scans, {});
}

SubmapEvidence of_two(const Pose2& a, const Pose2& b) {
  SubmapEvidence evidence({});
  evidence.add(submap_at(furnished_room(), a));
  evidence.add(submap_at(furnished_room(), b));
  return evidence;
}

TEST(SubmapEvidence, AMapOfAKnownPlaceCostsNothing) {
  const Pose2 a{-1.0, 0.0, 0.0}, b{1.0, 0.5, 0.4};
  SubmapEvidence evidence = of_two(a, b);
  EXPECT_GT(evidence.log_likelihood(1, {a, b}), -0.2 * 0.1 * 3.5 * 64);
}

TEST(SubmapEvidence, ANewPlaceAddsAtLeastWhatItsNeighboursExplain) {
  const Pose2 a{}, b{1.0, 0.5, 0.4};
  SubmapEvidence evidence = of_two(a, b);
  EXPECT_GE(evidence.of_a_new_place(1, {a, b}, 1), evidence.log_likelihood(1, {a, b}));
  EXPECT_DOUBLE_EQ(evidence.of_a_new_place(1, {a, b}, 0), -0.1 * 3.5 * 64);
}

// 64 points, a tenth of each: what a place costs that nobody saw before.
TEST(SubmapEvidence, ANewPlaceCostsWhatAllItsPointsDo) {
  const Pose2 a{}, b{1.0, 0.5, 0.4}, far{100.0, 0.0, 0.0};
  SubmapEvidence evidence = of_two(a, b);
  EXPECT_DOUBLE_EQ(evidence.log_likelihood(0, {a, far}), -0.1 * 3.5 * 64);
  EXPECT_DOUBLE_EQ(evidence.log_likelihood(1, {a, far}), -0.1 * 3.5 * 64);
}

// 6.3.4: without what was looked through the empty set of constraints would always win, as a path
// that is not bent is the likeliest under its motions. Here a map that lies 1 m beside where it
// belongs costs more than one elsewhere.
TEST(SubmapEvidence, APlaceThatContradictsCostsMoreThanANewOne) {
  const Pose2 a{}, b{1.0, 0.5, 0.4};
  SubmapEvidence evidence = of_two(a, b);
  const double beside = evidence.log_likelihood(1, {a, Pose2{0.0, 1.0, 0.0} * b});
  const double elsewhere = evidence.log_likelihood(1, {a, {100.0, 0.0, 0.0}});
  const double right = evidence.log_likelihood(1, {a, b});
  EXPECT_LT(beside, elsewhere);
  EXPECT_GT(right, elsewhere + 10.0);
}

TEST(SubmapEvidence, IsNeverPositiveAndAddsUp) {
  const Pose2 a{}, b{1.0, 0.5, 0.4};
  SubmapEvidence evidence = of_two(a, b);
  for (const double turn : {0.0, 0.1, 1.0, 3.0}) {
    const std::vector<Pose2> poses{a, {0.3, 0.2, turn}};
    EXPECT_LE(evidence.log_likelihood(1, poses), 0.0);
    EXPECT_DOUBLE_EQ(evidence.log_likelihood(poses),
                     evidence.log_likelihood(0, poses) + evidence.log_likelihood(1, poses));
  }
}

}  // namespace
}  // namespace mapbed
