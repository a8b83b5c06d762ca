#include "algorithms/field/likelihood_slope.h"

#include <functional>

#include <gtest/gtest.h>

namespace mapbed {
namespace {

// Single mapped points, farther from each other than one changes the field, and beams that end
// beside them: nowhere does a small step change which point is the nearest.
class LikelihoodSlopeOf : public ::testing::TestWithParam<std::vector<float>> {
 protected:
  LikelihoodSlopeOf() {
    for (const Eigen::Vector2d& point : mapped_) field_.add({.position = point});
    std::vector<Eigen::Vector2d> ends;
    for (std::size_t i = 0; i < mapped_.size(); ++i) {
      ends.emplace_back(inverse(pose_) * (mapped_[i] + off_[i]));
    }
    points_ = to_field_points(ends, field_.resolution(), GetParam());
  }

  double log_after(double forward, double left, double turn) const {
    return field_.sum_log_at(points_, pose_ * Pose2{forward, left, turn});
  }

  const std::vector<Eigen::Vector2d> mapped_{{3.02, 0.03}, {0.04, 2.01}, {-1.98, -1.02}};
  // [m] By less than half a sigma and more than two.
  const std::vector<Eigen::Vector2d> off_{{0.02, -0.01}, {-0.05, 0.08}, {0.03, 0.12}};
  const Pose2 pose_{0.4, -0.3, 0.7};
  LikelihoodField field_;
  FieldPoints points_;
};

TEST_P(LikelihoodSlopeOf, PointsIsTheNumericDerivative) {
  const LikelihoodSlope found = likelihood_slope(points_, 0, points_.size(), field_, pose_);
  // Points are floats of at most 100 cells of 5 cm, so 4e-7 m each; the field changes by 20 a metre
  // at most, which makes 0.02 in a difference of three points over 2e-3 m. Curvatures of the third
  // order, below 1 / sigma^3 = 5e3 a point, times h^2 / 6 make less than 0.01 a point.
  constexpr double h = 1e-3;
  EXPECT_NEAR(found.slope(0), (log_after(h, 0, 0) - log_after(-h, 0, 0)) / (2 * h), 0.05);
  EXPECT_NEAR(found.slope(1), (log_after(0, h, 0) - log_after(0, -h, 0)) / (2 * h), 0.05);
  EXPECT_NEAR(found.slope(2), (log_after(0, 0, h) - log_after(0, 0, -h)) / (2 * h), 0.15);
  EXPECT_GT(found.slope.cwiseAbs().minCoeff(), 1.0) << "a test that tells";
}

TEST_P(LikelihoodSlopeOf, SomePointsIsThatOfTheseAlone) {
  const LikelihoodSlope all = likelihood_slope(points_, 0, 3, field_, pose_);
  const LikelihoodSlope first = likelihood_slope(points_, 0, 1, field_, pose_);
  const LikelihoodSlope rest = likelihood_slope(points_, 1, 3, field_, pose_);
  EXPECT_LT((first.slope + rest.slope - all.slope).norm(), 1e-9);
  EXPECT_LT((first.curvature + rest.curvature - all.curvature).norm(), 1e-9);
  EXPECT_GT(first.slope.norm(), 1.0);
}

INSTANTIATE_TEST_SUITE_P(LikelihoodSlope, LikelihoodSlopeOf,
                         ::testing::Values(std::vector<float>{},
                                           std::vector<float>{1.0F, 0.25F, 0.5F}));

// A beam that ends on a mapped point: there Gauss-Newton's curvature is the true one.
TEST(LikelihoodSlope, OnTheMapTheCurvatureIsTheNumericSecondDerivative) {
  LikelihoodField field;
  const Pose2 pose{0.4, -0.3, 0.7};
  const Eigen::Vector2d mapped{2.03, 1.02};
  field.add({.position = mapped});
  const FieldPoints points = to_field_points({inverse(pose) * mapped}, field.resolution());
  const LikelihoodSlope found = likelihood_slope(points, 0, 1, field, pose);
  constexpr double h = 5e-3;
  const double middle = field.sum_log_at(points, pose);
  const auto minus_second = [&](const Pose2& ahead, const Pose2& back) {
    return -(field.sum_log_at(points, pose * ahead) - 2 * middle +
             field.sum_log_at(points, pose * back)) /
           (h * h);
  };
  EXPECT_LT(found.slope.norm(), 0.01);
  // ln p falls by h^2 / (2 sigma^2) = 3.5e-3, of which floats of a few units keep 1e-6.
  for (const auto& [i, second] : {std::pair{0, minus_second({h, 0, 0}, {-h, 0, 0})},
                                  {1, minus_second({0, h, 0}, {0, -h, 0})},
                                  {2, minus_second({0, 0, h}, {0, 0, -h})}}) {
    EXPECT_NEAR(found.curvature(i, i) / second, 1.0, 0.02) << i;
  }
  EXPECT_LT((found.curvature - found.curvature.transpose()).norm(), 1e-9);
}

}  // namespace
}  // namespace mapbed
