#include "algorithms/dynamic_em/beam_expectation.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mapbed {
namespace {

constexpr double kP = 0.8;  // p(c)
const BeamTerms kTerms{.log_path = -0.3, .m_end = 0.6};

TEST(BeamExpectation, TheJointIsTheLikelihoodGivenTheCauseTimesItsPrior) {  // (4.3), (4.4)
  EXPECT_NEAR(std::exp(log_joint_likelihood(kTerms, true, true, kP)), std::exp(-0.3) * 0.6 * 0.8,
              1e-15);
  EXPECT_NEAR(std::exp(log_joint_likelihood(kTerms, true, false, kP)), std::exp(-0.3) * 0.4 * 0.2,
              1e-15);
  // Given the cause, z depends on it: were they independent, both would be the same.
  EXPECT_NE(log_likelihood_given_cause(kTerms, true, true),
            log_likelihood_given_cause(kTerms, true, false));
}

TEST(BeamExpectation, OfTheCauseIsBayesRuleOnTheJoint) {  // (4.10)
  const double caused = std::exp(log_joint_likelihood(kTerms, true, true, kP));
  const double not_caused = std::exp(log_joint_likelihood(kTerms, true, false, kP));
  EXPECT_NEAR(expectation_of_cause(kTerms, true, kP), caused / (caused + not_caused), 1e-15);
  EXPECT_EQ(expectation_of_cause(kTerms, false, kP), kP);
}

TEST(BeamExpectation, OfTheLogLikelihoodIsTheMeanOverBothCauses) {  // (4.6), (4.7), (4.9)
  for (const bool hit : {true, false}) {
    const double e = expectation_of_cause(kTerms, hit, kP);
    const double mean = e * log_joint_likelihood(kTerms, hit, true, kP) +
                        (1.0 - e) * log_joint_likelihood(kTerms, hit, false, kP);
    EXPECT_NEAR(expected_log_likelihood(kTerms, hit, e) + expected_log_prior(e, kP), mean, 1e-15);
  }
}

TEST(BeamExpectation, CountsThePathOfEveryBeamAndTheEndOfThoseThatHit) {  // (4.7)
  EXPECT_EQ(expected_log_likelihood(kTerms, /*hit=*/false, 0.9), -0.3);
  EXPECT_NEAR(expected_log_likelihood(kTerms, /*hit=*/true, 0.9),
              -0.3 + 0.9 * std::log(0.6) + 0.1 * std::log(0.4), 1e-15);
  const BeamTerms longer{.log_path = -1.3, .m_end = 0.6};
  for (const bool hit : {true, false}) {
    EXPECT_NEAR(
        expected_log_likelihood(kTerms, hit, 0.9) - expected_log_likelihood(longer, hit, 0.9), 1.0,
        1e-15);
  }
}

TEST(BeamExpectation, OfThePriorDiffersBetweenIterations) {  // (4.9) is no constant
  EXPECT_NE(expected_log_prior(0.9, kP), expected_log_prior(0.5, kP));
}

}  // namespace
}  // namespace mapbed
