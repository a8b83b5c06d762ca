#include "algorithms/pose_graph/robust_loss.h"

#include <cmath>

#include <gtest/gtest.h>

#include "algorithms/pose_graph/graduated_weights.h"

namespace mapbed {
namespace {

constexpr RobustLoss kLosses[] = {RobustLoss::none,
                                  RobustLoss::huber,
                                  RobustLoss::cauchy,
                                  RobustLoss::geman_mcclure,
                                  RobustLoss::switchable,
                                  RobustLoss::graduated_truncated,
                                  RobustLoss::graduated_geman_mcclure};

TEST(RobustLoss, ItsWeightIsTheSlopeOfItsCost) {
  constexpr double kStep = 1e-6;
  for (const RobustLoss loss : kLosses) {
    for (const double u : {0.01, 0.5, 1.9, 2.1, 7.0, 1e3}) {
      const double slope =
          (robust_cost(loss, 2.0, u + kStep).cost - robust_cost(loss, 2.0, u - kStep).cost) /
          (2.0 * kStep);
      EXPECT_NEAR(robust_cost(loss, 2.0, u).weight, slope, 1e-7);
    }
  }
}

TEST(RobustLoss, CountsSmallErrorsAsTheyAreAndHasNoStep) {
  for (const RobustLoss loss : kLosses) {
    EXPECT_NEAR(robust_cost(loss, 2.0, 1e-9).cost, 1e-9, 1e-17);
    EXPECT_NEAR(robust_cost(loss, 2.0, 1e-9).weight, 1.0, 1e-8);
    EXPECT_NEAR(robust_cost(loss, 2.0, 2.0 - 1e-9).cost, robust_cost(loss, 2.0, 2.0 + 1e-9).cost,
                1e-8);
  }
}

// Agarwal et al. (2013): errors are scaled by min(1, 2 Phi / (Phi + chi2)).
TEST(RobustLoss, SwitchableScalesAsDynamicCovarianceScaling) {
  const double phi = 1.5;
  for (const double chi2 : {0.1, 1.4, 1.6, 20.0}) {
    const double scale = std::min(1.0, 2.0 * phi / (phi + chi2));
    EXPECT_NEAR(robust_cost(RobustLoss::switchable, phi, chi2).weight, scale * scale, 1e-15);
  }
}

TEST(GraduatedWeights, BeginConvexAndEndAtZeroOrOne) {
  const std::vector<double> chi_squares = {0.0, 5.0, 9.0, 12.0, 400.0};
  GraduatedWeights graduated(RobustLoss::graduated_truncated, 10.0, chi_squares);
  ASSERT_FALSE(graduated.is_done());
  const std::vector<double> first = graduated.next(chi_squares);
  EXPECT_EQ(first[0], 1.0);
  // mu / (mu + 1) c^2 = c^4 / (2 r^2) = 0.125 < 5: in between, where the largest is at its bound.
  EXPECT_GT(first[1], first[2]);
  EXPECT_LT(first[4], 0.02);
  std::vector<double> weights = first;
  int rounds = 1;
  for (; !graduated.is_done() && rounds < 200; ++rounds) weights = graduated.next(chi_squares);
  EXPECT_LT(rounds, 60);
  EXPECT_EQ(weights, (std::vector<double>{1.0, 1.0, 1.0, 0.0, 0.0}));
}

TEST(GraduatedWeights, GemanMcClureEndsAtItsOwnWeights) {
  const std::vector<double> chi_squares = {0.0, 5.0, 400.0};
  GraduatedWeights graduated(RobustLoss::graduated_geman_mcclure, 10.0, chi_squares);
  std::vector<double> weights;
  while (!graduated.is_done()) weights = graduated.next(chi_squares);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    EXPECT_EQ(weights[i], robust_cost(RobustLoss::geman_mcclure, 10.0, chi_squares[i]).weight);
  }
}

TEST(GraduatedWeights, HaveNothingToDoWhereAllIsRight) {
  EXPECT_TRUE(GraduatedWeights(RobustLoss::graduated_truncated, 10.0, {1.0, 9.9}).is_done());
  EXPECT_TRUE(GraduatedWeights(RobustLoss::graduated_truncated, 10.0, {}).is_done());
}

}  // namespace
}  // namespace mapbed
