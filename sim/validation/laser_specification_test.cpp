#include "sim/validation/laser_specification.h"

#include <cmath>
#include <numeric>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

// 10 m, steps of 1 cm, nothing but the statistical error of 1 cm.
LaserModel plain_laser() {
  LaserModel laser;
  laser.max_range = 10.0;
  laser.noise = {.sigma_near = 0.01,
                 .sigma_far = 0.01,
                 .step = 0.01,
                 .dark_range = 0.0,
                 .miss_probability = 0.0,
                 .short_probability = 0.0,
                 .random_probability = 0.0};
  return laser;
}

ReadingFractions fractions_of(const LaserTarget& target, const LaserModel& laser) {
  return specified_fractions(target, laser, spot_model_of(laser), 1000);
}

double sum(const ReadingFractions& fractions, std::size_t first, std::size_t last) {
  double result = 0.0;
  for (std::size_t k = first; k <= last; ++k) result += fractions[k];
  return result;
}

TEST(LaserSpecification, AWallGivesTheNormalDistributionInSteps) {
  const ReadingFractions fractions = fractions_of(wall_target("plaster", 5.0, 0.0), plain_laser());
  EXPECT_NEAR(fractions[500], std::erf(0.5 / std::sqrt(2.0)), 1e-12);
  EXPECT_NEAR(fractions[499], fractions[501], 1e-12);
  EXPECT_NEAR(sum(fractions, 0, 500), 0.5 + fractions[500] / 2.0, 1e-12);
}

TEST(LaserSpecification, ProbabilitiesSumToOne) {
  LaserModel laser = plain_laser();
  laser.noise = LaserNoise{};
  laser.noise.miss_probability = 0.1;
  laser.noise.short_probability = 0.2;
  laser.noise.random_probability = 0.05;
  for (const LaserTarget& target :
       {wall_target("plaster", 5.004, 0.3), wall_target("plastic", 9.998, 1.4),
        glass_target(3.0, 0.1, 2.0), edge_target(laser, 3.0, 0.2), edge_target(laser, 3.0, 2.0),
        leg_target(laser, 3.0, 0.07, 2.0)}) {
    const ReadingFractions fractions = fractions_of(target, laser);
    EXPECT_NEAR(std::accumulate(fractions.begin(), fractions.end(), 0.0), 1.0, 1e-9);
    EXPECT_EQ(fractions[0], 0.0);
  }
}

TEST(LaserSpecification, GrossReadingsAreUniform) {
  LaserModel laser = plain_laser();
  laser.noise.random_probability = 0.1;
  laser.noise.short_probability = 0.5;
  const ReadingFractions fractions = fractions_of(wall_target("plaster", 5.0, 0.0), laser);
  EXPECT_NEAR(fractions[300], 0.1 / 1000 + 0.9 * 0.5 / 500, 1e-12);
  EXPECT_NEAR(fractions[700], 0.1 / 1000, 1e-12);
  EXPECT_NEAR(fractions.back(), 0.1 / 2000, 1e-12);  // half a step
}

TEST(LaserSpecification, ASurfaceAtItsLimitIsSeenHalfTheTime) {
  LaserModel laser = plain_laser();
  laser.noise.dark_range = 5.0 / std::sqrt(7.5 * 0.5);  // plaster: 0.75, at 60 deg
  const ReadingFractions fractions =
      fractions_of(wall_target("plaster", 5.0, radians(60.0)), laser);
  EXPECT_NEAR(fractions.back(), 0.5, 1e-9);
}

TEST(LaserSpecification, BehindAnEdgeHalfTheReadingsSeeTheFarWall) {
  LaserModel laser = plain_laser();
  laser.divergence = 0.0;
  laser.noise.mixed_pixels = MixedPixels::either;
  // By symmetry the near wall has half of the light; its power is (5 / 3)^2 times that of the far.
  // A place whose spot is near by a fraction s reads near with s / (s + (1 - s) 9 / 25).
  const ReadingFractions fractions =
      specified_fractions(edge_target(laser, 3.0, 2.0), laser, {.sub_rays = 1}, 1000);
  EXPECT_NEAR(sum(fractions, 0, 400), 0.5, 1e-9);

  const ReadingFractions two_rays =
      specified_fractions(edge_target(laser, 3.0, 2.0), laser, {.sub_rays = 3}, 3000);
  // Sub-rays at -2/3, 0, 2/3 of the half width: the spot is near by 1, 1 - c, c and 0 of its light
  // in 1/6, 1/3, 1/3 and 1/6 of the places, c being the outer one's fraction.
  const double chord = std::sqrt(1.0 - 4.0 / 9.0);
  const double c = chord / (1.0 + 2.0 * chord);
  const auto near = [](double s) { return s / (s + (1.0 - s) * 9.0 / 25.0); };
  EXPECT_NEAR(sum(two_rays, 0, 400), 1.0 / 6.0 + near(1.0 - c) / 3.0 + near(c) / 3.0, 1e-9);
}

TEST(LaserSpecification, ALegIsSeenWhereItsOutlineIs) {
  LaserModel laser = plain_laser();
  laser.divergence = laser.aperture = 0.0;
  LaserTarget leg = leg_target(laser, 3.0, 0.07, 2.0);
  leg.half_width = 0.14;
  const ReadingFractions fractions = specified_fractions(leg, laser, spot_model_of(laser), 10'000);
  EXPECT_NEAR(sum(fractions, 0, 400), 0.5, 1e-4);
  // The deepest point is seen by the sides: ranges from 2.93 to 3 m.
  EXPECT_NEAR(sum(fractions, 285, 308), 0.5, 1e-4);
}

TEST(LaserSpecification, GlassAnswersAsItsMaterialSays) {
  const LaserModel laser = plain_laser();
  const Material& glass =
      standard_materials()[static_cast<std::size_t>(material_index(World{}, "glass"))];
  const ReadingFractions fractions = fractions_of(glass_target(3.0, 0.1, 2.0), laser);
  EXPECT_NEAR(sum(fractions, 0, 400), hit_probability(glass, 0.1), 1e-9);
}

}  // namespace
}  // namespace mapbed
