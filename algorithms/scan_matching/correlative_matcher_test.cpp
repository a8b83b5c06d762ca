#include "algorithms/scan_matching/correlative_matcher.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/scan/hit_points.h"
#include "algorithms/scan/surface_points.h"
#include "core/testing/is_near.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

class FindsTheOptimumOfExhaustiveSearch : public ::testing::TestWithParam<int> {};

TEST_P(FindsTheOptimumOfExhaustiveSearch, WithAndWithoutAPrior) {
  Rng rng(static_cast<std::uint64_t>(GetParam()));
  TestRoom room = rectangular_room(6.0, 4.0);
  room.add_box({rng.uniform(-2, 2), rng.uniform(-1, 1)}, 0.8, 0.5, rng.uniform(0, 3));
  const Pose2 truth{rng.uniform(-2, 2), rng.uniform(-1.2, 1.2), rng.uniform(-3, 3)};
  LikelihoodField field;
  const LaserScan past = with_range_noise(scan_of(room, truth * Pose2{-0.3, 0.1, 0.2}), 0.02, rng);
  field.add(transformed(surface_points(past, 30.0, 0.2, 0.05), truth * Pose2{-0.3, 0.1, 0.2}));
  const LaserScan scan = with_range_noise(scan_of(room, truth), 0.02, rng);
  const FieldPoints points =
      to_field_points(hit_points(scan, {.min_spacing = 0.2}), field.resolution());
  const Pose2 guess =
      truth * Pose2{rng.uniform(-0.4, 0.4), rng.uniform(-0.4, 0.4), rng.uniform(-0.3, 0.3)};
  const CorrelativeMatcherOptions options{.window = 0.6, .turn_window = 0.4, .turn_step = 0.04};

  for (const PosePrior& prior :
       {PosePrior{.mean = guess}, independent_prior(guess, 0.1, 0.3, 0.1)}) {
    const ScanMatch plain = match_exhaustive(points, field, prior, options);
    const ScanMatch fast =
        match_correlative(points, field, make_bound_pyramid(field, options.window), prior, options);
    EXPECT_NEAR(fast.log_posterior, plain.log_posterior, 1e-6);
    EXPECT_THAT(fast.map_from_robot, IsNear(plain.map_from_robot, Tolerance{1e-9, 1e-9}));
  }
}

INSTANTIATE_TEST_SUITE_P(CorrelativeMatcher, FindsTheOptimumOfExhaustiveSearch,
                         ::testing::Range(0, 8));

TEST(BoundPyramid, NeverLiesBelowWhatItBounds) {
  LikelihoodField field;
  Rng rng(9);
  for (int i = 0; i < 60; ++i) field.add(SurfacePoint{{rng.uniform(-1, 1), rng.uniform(-1, 1)}});
  const BoundPyramid pyramid = make_bound_pyramid(field, 6.4);
  ASSERT_GE(pyramid.levels.back().thinning, 3);
  for (std::size_t level = 0; level < pyramid.levels.size(); ++level) {
    for (int i = 0; i < 500; ++i) {
      const Eigen::Vector2d shifted(rng.uniform(-1.2, 1.2), rng.uniform(-1.2, 1.2));
      const auto reach = static_cast<std::uint64_t>(1) << level;
      const Eigen::Vector2d p =
          shifted - 0.05 * Eigen::Vector2d(double(rng.index(reach)), double(rng.index(reach)));
      const int bound = pyramid.levels[level].at(static_cast<int>(std::floor(p.x() / 0.05)),
                                                 static_cast<int>(std::floor(p.y() / 0.05)));
      EXPECT_GE(double{field.outlier_log()} + bound * pyramid.step, field.log_at(shifted) - 1e-5);
    }
  }
}

// Thinned, an entry covers up to half as many cells more; there is nothing to score beyond.
TEST(BoundPyramid, IsZeroWhereNoShiftReachesTheMap) {
  LikelihoodField field;
  field.add(SurfacePoint{{0.0, 0.0}});
  const BoundPyramid pyramid = make_bound_pyramid(field, 6.4);
  for (std::size_t level = 0; level < pyramid.levels.size(); ++level) {
    const int reach = 32 + (3 << level) / 2;  // a tile, and the level's
    EXPECT_EQ(pyramid.levels[level].at(-reach - 1, 0), 0) << level;
    EXPECT_EQ(pyramid.levels[level].at(33, 0), 0) << level;
    EXPECT_EQ(pyramid.levels[level].at(0, 33), 0) << level;
    EXPECT_GT(pyramid.levels[level].at(0, 0), 0) << level;
  }
}

// A window so large that turns are bounded in groups.
TEST(CorrelativeMatcher, FindsTheOptimumOfExhaustiveSearchInALargeWindow) {
  const TestRoom room = example_place();
  const Pose2 truth{2.0, 2.0, 0.3};
  LikelihoodField field({.resolution = 0.2, .sigma = 0.2});
  field.add(transformed(surface_points(scan_of(room, truth), 30.0, 0.2, 0.2), truth));
  const FieldPoints points =
      to_field_points(hit_points(scan_of(room, truth), {.max_points = 20}), 0.2);
  const CorrelativeMatcherOptions options{.window = 4.2, .turn_window = 3.2, .turn_step = 0.05};
  const PosePrior far{.mean = truth * Pose2{3.1, -2.2, 2.5}};
  const BoundPyramid pyramid = make_bound_pyramid(field, options.window);
  ASSERT_GE(pyramid.levels.size(), 6U);
  const ScanMatch plain = match_exhaustive(points, field, far, options);
  const ScanMatch fast = match_correlative(points, field, pyramid, far, options);
  EXPECT_NEAR(fast.log_posterior, plain.log_posterior, 1e-6);
  EXPECT_THAT(fast.map_from_robot, IsNear(plain.map_from_robot, Tolerance{1e-9, 1e-9}));
}

TEST(CorrelativeMatcher, FindsAStartErrorThatHillClimbingDoesNot) {
  const TestRoom room = example_place();
  const Pose2 truth{2.0, 2.0, 0.3};
  LikelihoodField field;
  field.add(transformed(surface_points(scan_of(room, truth), 30.0, 0.2, 0.05), truth));
  const FieldPoints points =
      to_field_points(hit_points(scan_of(room, truth), {}), field.resolution());
  const PosePrior far{.mean = truth * Pose2{1.5, -1.2, 0.5}};
  const CorrelativeMatcherOptions options{.window = 2.5, .turn_window = 0.8};
  const ScanMatch found =
      match_correlative(points, field, make_bound_pyramid(field, 2.5), far, options);
  EXPECT_THAT(found.map_from_robot, IsNear(truth, Tolerance{0.06, 0.02}));
  EXPECT_GT(distance(match_scan(points, field, far).map_from_robot, truth), 0.2);
}

TEST(CorrelativeMatcher, KeepsThePredictionWhenNothingWasHit) {
  const LikelihoodField empty;
  const Pose2 guess{1, 2, 0.5};
  const ScanMatch match = match_correlative({}, empty, make_bound_pyramid(empty, 0.5),
                                            PosePrior{.mean = guess}, {.window = 0.5});
  EXPECT_EQ(match.map_from_robot, guess);
  EXPECT_FALSE(match.trustworthy);
}

// The prior ties place and heading: 2 m to the left for each radian, as behind a long lever. Where
// the robot is, 0.4 m and 0.2 rad off the mean, it says as much for it as at the mean itself.
TEST(CorrelativeMatcher, FindsTheOptimumOfAPriorThatTiesPlaceAndHeading) {
  TestRoom room = rectangular_room(6.0, 4.0);
  room.add_box({1.0, 0.6}, 0.8, 0.5, 0.4);
  const Pose2 guess{0.3, -0.6, 0.0}, truth{0.3, -0.2, 0.2};  // both on the lattice
  LikelihoodField field;
  field.add(transformed(surface_points(scan_of(room, truth), 30.0, 0.2, 0.05), truth));
  const FieldPoints points =
      to_field_points(hit_points(scan_of(room, truth), {.min_spacing = 0.2}), field.resolution());
  const Eigen::Vector3d across(0.0, 1.0, -2.0);  // of errors that it does not allow
  const PosePrior prior{.mean = guess,
                        .information = 1e4 * across * across.transpose() +
                                       Eigen::Matrix3d(Eigen::Matrix3d::Identity())};
  const CorrelativeMatcherOptions options{.window = 0.6, .turn_window = 0.4, .turn_step = 0.04};

  const ScanMatch fast =
      match_correlative(points, field, make_bound_pyramid(field, options.window), prior, options);

  EXPECT_THAT(fast.map_from_robot, IsNear(truth, Tolerance{1e-9, 1e-9}));
  const ScanMatch plain = match_exhaustive(points, field, prior, options);
  EXPECT_NEAR(fast.log_posterior, plain.log_posterior, 1e-6);
}

// 8 cm are a cell and a half of 5 cm: a robot 10 cm off is found.
TEST(CorrelativeMatcher, SearchesTheWholeCellsThatItsWindowReachesInto) {
  TestRoom room = rectangular_room(6.0, 4.0);
  room.add_box({1.0, 0.6}, 0.8, 0.5, 0.4);
  const Pose2 truth{0.3, -0.2, 0.1};
  LikelihoodField field;
  field.add(transformed(surface_points(scan_of(room, truth), 30.0, 0.2, 0.05), truth));
  const FieldPoints points = to_field_points(hit_points(scan_of(room, truth), {}), 0.05);
  const CorrelativeMatcherOptions options{.window = 0.08, .turn_window = 0.0, .turn_step = 0.04};
  const BoundPyramid pyramid = make_bound_pyramid(field, options.window);
  for (const double off : {-0.1, 0.1}) {
    const PosePrior guess{.mean = {truth.x + off, truth.y - off, truth.theta}};
    EXPECT_THAT(match_correlative(points, field, pyramid, guess, options).map_from_robot,
                IsNear(truth, Tolerance{1e-9, 1e-9}));
  }
}

}  // namespace
}  // namespace mapbed
