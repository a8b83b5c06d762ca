#include "worlds/geometry/material.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mapbed {
namespace {

// Of each ten beams seven go through, but nearly none of those that meet the pane head on.
TEST(Material, APaneAnswersByAGaussianAboutItsNormal) {
  const Material pane{.transmittance = 0.7, .specular_hit = 0.95, .specular_width = 0.1};
  EXPECT_NEAR(hit_probability(pane, 0.0), 0.95, 1e-12);
  EXPECT_NEAR(hit_probability(pane, 0.1), 0.3 + 0.65 * std::exp(-0.5), 1e-12);
  EXPECT_NEAR(hit_probability(pane, 0.2), 0.3 + 0.65 * std::exp(-2.0), 1e-12);
  EXPECT_NEAR(hit_probability(pane, 1.5), 0.3, 1e-12);
}

TEST(Material, WhatIsOpaqueAlwaysAnswers) {
  const Material wall{.transmittance = 0.0, .specular_hit = 0.1, .specular_width = 0.1};
  EXPECT_EQ(hit_probability(wall, 0.0), 1.0);
  EXPECT_EQ(hit_probability(wall, 1.5), 1.0);
}

}  // namespace
}  // namespace mapbed
