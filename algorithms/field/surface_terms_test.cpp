#include "algorithms/field/surface_terms.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace mapbed {
namespace {

using Floats = HitsOnSurface::Floats;

const HitMixture kMixture(0.08, 0.85, 4.0, 512);

// Some of them near no surface, and some of the surfaces without a line.
HitsOnSurface scattered(std::size_t count, std::uint64_t seed) {
  Rng rng(seed);
  const auto between = [&](double reach) { return static_cast<float>(rng.uniform(-reach, reach)); };
  HitsOnSurface hits{.count = count};
  for (std::size_t i = 0; i < count; ++i) {
    hits.found[i] = rng.uniform(0, 1) < 0.8 ? 1 : 0;
    const float any = hits.found[i] != 0 ? 1.0F : 0.0F;
    hits.arm_x[i] = between(10);
    hits.arm_y[i] = between(10);
    hits.off_x[i] = any * between(0.15);
    hits.off_y[i] = any * between(0.15);
    hits.doubled_x[i] = any * between(0.8);
    hits.doubled_y[i] = any * between(0.8);
  }
  return hits;
}

void expect_same(const Floats& a, const Floats& b, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(a[i], b[i]) << i;
}

TEST(SurfaceTerms, AreTheSameOnEachProcessor) {
  if (this_processor() == Processor::any) GTEST_SKIP() << "this machine has but one";
  Floats weights;
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = static_cast<float>(i) / 64.0F;
  for (const std::size_t count : {1U, 7U, 16U, 61U, 64U}) {
    const HitsOnSurface hits = scattered(count, count);
    for (const bool weighted : {false, true}) {
      const float* its = weighted ? weights.data() : nullptr;
      SurfaceTerms plain, wide;
      surface_terms(hits, kMixture, its, plain, Processor::any);
      surface_terms(hits, kMixture, its, wide, Processor::avx2);
      for (const auto member :
           {&SurfaceTerms::log, &SurfaceTerms::pull_x, &SurfaceTerms::pull_y,
            &SurfaceTerms::pull_turn, &SurfaceTerms::xx, &SurfaceTerms::xy, &SurfaceTerms::yy,
            &SurfaceTerms::x_turn, &SurfaceTerms::y_turn, &SurfaceTerms::turn_turn}) {
        expect_same(plain.*member, wide.*member, count);
      }
    }
  }
}

// By differences: how the log-likelihood of a hit beside a wall changes as the hit moves.
TEST(SurfaceTerms, PullAsTheLikelihoodRises) {
  constexpr float kSigma = 0.08F, kStep = 1e-3F;
  HitsOnSurface hits{.count = 3};
  for (std::size_t i = 0; i < 3; ++i) {
    hits.found[i] = 1;
    hits.arm_x[i] = 2.0F;
    hits.arm_y[i] = 1.0F;
    hits.off_x[i] = 0.0F;
    hits.off_y[i] = 0.05F + kStep * (static_cast<float>(i) - 1.0F);
    hits.doubled_x[i] = 1.0F;  // along x
    hits.doubled_y[i] = 0.0F;
  }
  SurfaceTerms terms;
  surface_terms(hits, kMixture, nullptr, terms);
  const float rise = (terms.log[2] - terms.log[0]) / (2.0F * kStep);
  // The table is linear over steps of 1/32 in d^2 / sigma^2.
  EXPECT_NEAR(-terms.pull_y[1] / (kSigma * kSigma), rise, 0.02F * std::abs(rise));
  EXPECT_EQ(terms.pull_x[1], 0.0F);
  EXPECT_FLOAT_EQ(terms.pull_turn[1], 2.0F * terms.pull_y[1]);
}

}  // namespace
}  // namespace mapbed
