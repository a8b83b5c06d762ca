// What a weight of a point counts, in each way to match a scan.

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/scan/hit_points.h"
#include "algorithms/scan/surface_points.h"
#include "algorithms/scan_matching/correlative_matcher.h"
#include "algorithms/scan_matching/icp_matcher.h"
#include "algorithms/scan_matching/scan_matcher.h"
#include "core/testing/is_near.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

using Points = std::vector<Eigen::Vector2d>;
using Weights = std::vector<float>;  // empty: all count fully

class PointWeights : public ::testing::TestWithParam<const char*> {
 protected:
  PointWeights() { field_.add(seen_in_map_); }

  ScanMatch match(const Points& points, const Weights& weights = {}) const {
    const std::string way = GetParam();
    if (way == "icp") return match_icp(points, IcpMap(seen_in_map_), prediction_, {}, weights);
    const FieldPoints in_cells = to_field_points(points, field_.resolution(), weights);
    if (way == "hill_climbing") return match_scan(in_cells, field_, prediction_);
    // Without a step of their own, turns go by the points' distances, whatever these weigh.
    const CorrelativeMatcherOptions options{.window = 0.3, .turn_window = 0.1, .turn_step = 0.01};
    return match_correlative(in_cells, field_, make_bound_pyramid(field_, options.window),
                             prediction_, options);
  }

  // Likelihoods are sums of floats: each addition errs by half a last bit of the sum at most.
  static double rounding(const ScanMatch& match, std::size_t additions) {
    return static_cast<double>(additions) * std::abs(match.log_likelihood) *
           double{std::numeric_limits<float>::epsilon()};
  }
  static void expect_same(const ScanMatch& found, const ScanMatch& expected, std::size_t points) {
    const double bound = rounding(expected, points);
    EXPECT_NEAR(found.log_likelihood, expected.log_likelihood, bound);
    EXPECT_NEAR(found.log_posterior, expected.log_posterior, bound);
    EXPECT_NEAR(found.inlier_ratio, expected.inlier_ratio, 1e-4);
    EXPECT_THAT(found.map_from_robot, IsNear(expected.map_from_robot, Tolerance{1e-5, 1e-5}));
  }

  const TestRoom room_ = rectangular_room(6.0, 4.0);
  const Pose2 truth_{0.3, -0.4, 0.2};
  const std::vector<SurfacePoint> seen_in_map_ =
      transformed(surface_points(scan_of(room_, truth_), 30.0, 0.2, 0.05), truth_);
  LikelihoodField field_;
  // Sure enough to pull against the scan: what beams count shows in the pose too.
  const PosePrior prediction_ =
      independent_prior(truth_ * Pose2{0.06, -0.04, 0.03}, 0.02, 0.02, 0.02);
  const Points hits_ = hit_points(scan_of(room_, truth_), {.min_spacing = 0.2});
};

TEST_P(PointWeights, TwoHalvesAtOnePlaceCountAsOne) {
  Points twice;
  for (const Eigen::Vector2d& hit : hits_) twice.insert(twice.end(), {hit, hit});
  expect_same(match(twice, Weights(twice.size(), 0.5F)), match(hits_), twice.size());
}

TEST_P(PointWeights, HalvesCountHalfAtTheSamePose) {
  const auto at_prediction = [this](const Weights& weights) {
    const PosePrior sure = independent_prior(truth_, 1e-7, 1e-7, 1e-7);
    if (std::string(GetParam()) == "icp")
      return match_icp(hits_, IcpMap(seen_in_map_), sure, {}, weights);
    const FieldPoints points = to_field_points(hits_, field_.resolution(), weights);
    return match_scan(points, field_, sure);
  };
  const ScanMatch whole = at_prediction({});
  const ScanMatch half = at_prediction(Weights(hits_.size(), 0.5F));
  EXPECT_NEAR(half.log_likelihood, 0.5 * whole.log_likelihood, rounding(whole, hits_.size()));
  EXPECT_NEAR(half.inlier_ratio, whole.inlier_ratio, 1e-4);
}

TEST_P(PointWeights, PointsThatWeighNothingAreAsIfTheyWereNotThere) {
  Points with_stray = hits_;
  Weights weights(hits_.size(), 1.0F);
  for (int i = 0; i < 20; ++i) {  // somebody beside the robot, and some of the walls again
    with_stray.insert(with_stray.begin() + 3 * i, {{1.0, 0.03 * i}, hits_[hits_.size() / 2]});
    weights.insert(weights.begin() + 3 * i, 2, 0.0F);
  }
  expect_same(match(with_stray, weights), match(hits_), with_stray.size());
}

TEST_P(PointWeights, LighterPointsPullLessAgainstThePrediction) {
  const auto pulled = [this](float weight) {
    return distance(match(hits_, Weights(hits_.size(), weight)).map_from_robot, prediction_.mean);
  };
  EXPECT_LT(pulled(0.002F), 0.5 * pulled(1.0F));
}

INSTANTIATE_TEST_SUITE_P(ScanMatching, PointWeights,
                         ::testing::Values("hill_climbing", "correlative", "icp"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace mapbed
