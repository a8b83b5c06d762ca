#include "algorithms/motion/motion_learning.h"

#include <cmath>

#include <Eigen/Dense>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/config/settings.h"
#include "core/data_path.h"
#include "core/input_error.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

const MotionModelOptions kTruth{.rotation_per_rotation = 0.10,
                                .rotation_per_meter = 0.05,
                                .translation_per_meter = 0.08,
                                .translation_per_rotation = 0.02,
                                .least_rotation_sigma = 0.004,
                                .least_translation_sigma = 0.006};

// Straight ways, turns on the spot and bends, and what a robot of this model does then.
std::vector<MotionSample> samples_of(const MotionModelOptions& model, int count) {
  std::vector<MotionSample> samples;
  Rng rng(7);
  for (int i = 0; i < count; ++i) {
    const double way = i % 3 == 0 ? 0.0 : rng.uniform(0.1, 0.6);
    const double turn = i % 3 == 1 ? 0.0 : rng.uniform(-0.8, 0.8);
    const Pose2 measured = Pose2{way, 0.0, 0.0} * Pose2{0.0, 0.0, turn};
    samples.push_back({measured, sampled_motion(measured, model, rng)});
  }
  return samples;
}

TEST(MotionLearning, FindsTheSigmasThatTheMotionsWereDrawnFrom) {
  const MotionModelOptions learned = learned_motion_model(samples_of(kTruth, 6000));
  // A sigma from n errors has a relative standard error of 1 / sqrt(2 n): 1.6 % of the 2000
  // motions of one kind; four of these, and as much again for the error being shared with floors.
  EXPECT_NEAR(learned.rotation_per_rotation, kTruth.rotation_per_rotation,
              0.15 * kTruth.rotation_per_rotation);
  EXPECT_NEAR(learned.rotation_per_meter, kTruth.rotation_per_meter,
              0.15 * kTruth.rotation_per_meter);
  EXPECT_NEAR(learned.translation_per_meter, kTruth.translation_per_meter,
              0.15 * kTruth.translation_per_meter);
}

TEST(MotionLearning, NoOtherSigmaIsLikelier) {
  const auto samples = samples_of(kTruth, 600);
  const MotionModelOptions learned = learned_motion_model(samples);
  const double best = mean_log_likelihood(samples, learned);
  EXPECT_GT(best, mean_log_likelihood(samples, MotionModelOptions{}));
  for (double MotionModelOptions::*sigma :
       {&MotionModelOptions::rotation_per_rotation, &MotionModelOptions::rotation_per_meter,
        &MotionModelOptions::translation_per_meter, &MotionModelOptions::translation_per_rotation,
        &MotionModelOptions::least_rotation_sigma, &MotionModelOptions::least_translation_sigma}) {
    for (const double factor : {0.9, 1.1}) {
      MotionModelOptions other = learned;
      other.*sigma *= factor;
      EXPECT_GE(best, mean_log_likelihood(samples, other)) << learned.*sigma;
    }
  }
}

TEST(MotionLearning, TheLikelihoodIsThatOfTheGaussian) {
  // A straight way of 1 m with all sigmas known: variances 0.04^2 along; turns alpha and beta of
  // 0.1 each; the determinant of the information by hand.
  MotionModelOptions model{.rotation_per_rotation = 0.0,
                           .rotation_per_meter = 0.0,
                           .translation_per_meter = 0.0,
                           .translation_per_rotation = 0.0,
                           .least_rotation_sigma = 0.1,
                           .least_translation_sigma = 0.04};
  const double a = 0.01, floor = 0.0016;
  // Along: way and floor; across and turn: [a + floor, a; a, 2 a + 1e-8].
  const double determinant = 2 * floor * ((a + floor) * (2 * a + 1e-8) - a * a);
  const double expected = -0.5 * std::log(determinant) - 1.5 * std::log(2 * std::acos(-1.0));
  const std::vector<MotionSample> exact{{Pose2{1, 0, 0}, Pose2{1, 0, 0}}};
  EXPECT_NEAR(mean_log_likelihood(exact, model), expected, 1e-9);
}

TEST(MotionLearning, FindsBiasesAndDoesNotTakeNoiseForOne) {
  // Straight ways whose measured turns are nothing but noise, and a few turns; turns are measured
  // 25 % too large, ways 2 % too short.
  std::vector<MotionSample> samples;
  Rng rng(3);
  for (int i = 0; i < 2000; ++i) {
    const double turn = i % 20 == 0 ? 0.8 : 0.0;
    samples.push_back(
        {Pose2{0.49, 0.0, 1.25 * turn + rng.normal(0.0, 0.1)}, Pose2{0.5, 0.0, turn}});
  }
  const MotionModelOptions learned = learned_motion_model(samples);
  // 100 turns of 0.8 rad: the standard error of the fraction is 0.1 / 0.8 / sqrt(100).
  EXPECT_NEAR(learned.rotation_bias, 1.0 - 1.0 / 1.25, 4 * 0.0125);
  EXPECT_NEAR(learned.translation_bias, 1.0 - 0.5 / 0.49, 1e-9);
}

TEST(MotionLearning, TheTrueModelIsCalibrated) {
  const int n = 4000;
  const Calibration calibration = calibration_of(samples_of(kTruth, n), kTruth);
  // e^T P e has mean 3 and variance 6; the fraction within has that of a toss of 0.95. Four
  // standard errors, and 5 % for the Gaussian being a linearisation of the turns.
  EXPECT_NEAR(calibration.nees, 1.0, 4 * std::sqrt(6.0) / 3 / std::sqrt(n) + 0.05);
  EXPECT_NEAR(calibration.coverage, 0.95, 4 * std::sqrt(0.95 * 0.05 / n) + 0.01);
}

TEST(MotionLearning, AModelThatIsTooSureIsFoundOut) {
  MotionModelOptions half = kTruth;
  for (double* sigma : {&half.rotation_per_rotation, &half.rotation_per_meter,
                        &half.translation_per_meter, &half.translation_per_rotation,
                        &half.least_rotation_sigma, &half.least_translation_sigma}) {
    *sigma *= 0.5;
  }
  const Calibration calibration = calibration_of(samples_of(kTruth, 1000), half);
  EXPECT_NEAR(calibration.nees, 4.0, 0.6);  // half the sigma, four times the square
  EXPECT_LT(calibration.coverage, 0.8);
}

TEST(MotionLearning, IndependentErrorsHaveNoMemoryAndRepeatedOnesDo) {
  const auto samples = samples_of(kTruth, 3000);
  // 9000 products of independent unit normals: a standard error of 1 / sqrt(9000); four of them.
  EXPECT_NEAR(autocorrelation_of(samples, kTruth), 0.0, 4 / std::sqrt(9000.0));
  // The same error over and over.
  const std::vector<MotionSample> same(100, {Pose2{0.5, 0.0, 0.0}, Pose2{0.52, 0.01, 0.02}});
  EXPECT_NEAR(autocorrelation_of(same, kTruth), 1.0, 1e-12);
}

TEST(MotionLearning, AThirdOfTheErrorThatRepeatsIsAThirdOfTheMemory) {
  const Pose2 measured{0.5, 0.0, 0.3};
  const PosePrior prior = gaussian_after({}, measured, kTruth);
  Rng rng(4);
  std::vector<MotionSample> samples;
  constexpr int kCount = 3000;
  for (int i = 0; i < kCount; ++i) {
    // Of three errors of unit variance, mixed as the model has it, the first is always the same.
    const Eigen::Vector3d unit(1.0, rng.normal(), rng.normal());
    const Eigen::Vector3d e = prior.information.llt().matrixU().solve(unit);
    samples.push_back({measured, prior.mean * Pose2{e.x(), e.y(), e.z()}});
  }
  EXPECT_NEAR(autocorrelation_of(samples, kTruth), 1.0 / 3.0, 5 / std::sqrt(3.0 * kCount));
}

TEST(MotionModelFile, AllAreRead) {
  const std::vector<std::string> names = data_names("algorithms/motion/motion_models");
  EXPECT_FALSE(names.empty());
  for (const std::string& name : names) EXPECT_NO_THROW(load_motion_model(name)) << name;
}

TEST(MotionModelFile, AnUnknownNameIsAnError) {
  EXPECT_INPUT_ERROR(load_motion_model("pioneer_odometri"),
                     "unknown motion model 'pioneer_odometri'");
}

}  // namespace
}  // namespace mapbed
