#include "algorithms/localization/particle_motion.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mapbed {
namespace {

constexpr int kParticles = 40'000;

double fraction_beyond(const std::vector<Pose2>& poses, double x, double distance) {
  int beyond = 0;
  for (const Pose2& pose : poses) beyond += std::abs(pose.x - x) > distance ? 1 : 0;
  return static_cast<double>(beyond) / static_cast<double>(poses.size());
}

TEST(ParticleMotion, MostParticlesMoveByOdometryAndSomeAsIfItHadSlipped) {
  ParticleErrors errors;
  errors.usual = {.rotation_per_rotation = 0.0,
                  .rotation_per_meter = 0.0,
                  .translation_per_meter = 0.1,
                  .translation_per_rotation = 0.0,
                  .least_rotation_sigma = 1e-6,
                  .least_translation_sigma = 1e-6};
  errors.slip_share = 0.2;
  errors.slip_factor = 10.0;
  std::vector<Pose2> poses(kParticles);
  move_particles(poses, {1.0, 0.0, 0.0}, errors, Rng(1));
  // A sigma of 0.1 m, or of 1 m: |error| > 0.5 m in one of 1.7 million, or in 0.6171 of them.
  const double expected = 0.2 * 0.6171;
  EXPECT_NEAR(fraction_beyond(poses, 1.0, 0.5), expected,
              5.0 * std::sqrt(expected * (1.0 - expected) / kParticles));
}

// Variances grow with time: 4 s are as four times one.
TEST(ParticleMotion, ARandomStepIsAboutWhereSomebodyWas) {
  std::vector<Pose2> poses(kParticles, Pose2{5.0, 0.0, 3.0});
  move_particles(poses, 4.0, RandomStepOptions{.position = 0.5, .heading = 0.1}, Rng(1));
  const double expected = 0.3173;  // beyond a sigma, of 1 m
  EXPECT_NEAR(fraction_beyond(poses, 5.0, 1.0), expected,
              5.0 * std::sqrt(expected * (1.0 - expected) / kParticles));
}

}  // namespace
}  // namespace mapbed
