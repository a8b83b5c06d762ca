#include "sim/noise/laser_noise.h"

#include <cmath>
#include <limits>

#include "core/statistics/moments.h"

namespace mapbed {
namespace {

constexpr int kBeams = 20'000;
constexpr float kNothing = std::numeric_limits<float>::infinity();

// Many equal beams, so that one scan is a sample of the noise.
IdealScan equal_beams(const std::vector<Echo>& echoes) {
  IdealScan scan;
  scan.first_echo.push_back(0);
  for (int k = 0; k < kBeams; ++k) {
    scan.echoes.insert(scan.echoes.end(), echoes.begin(), echoes.end());
    scan.first_echo.push_back(static_cast<std::uint32_t>(scan.echoes.size()));
  }
  return scan;
}

MountedLaser noiseless_laser() {
  MountedLaser laser;
  laser.model.beams = kBeams;
  laser.model.max_range = 80.0;
  laser.model.noise = {.sigma_near = 0.0,
                       .sigma_far = 0.0,
                       .step = 0.0,
                       .dark_range = 0.0,
                       .miss_probability = 0.0,
                       .short_probability = 0.0,
                       .random_probability = 0.0};
  return laser;
}

Echo wall_at(float range) {
  return {.range = range, .reflectivity = 0.5F};
}

std::vector<double> readings(const std::vector<Echo>& echoes, const MountedLaser& laser) {
  return with_noise(equal_beams(echoes), laser, Rng(42)).ranges;
}

double fraction_of(const std::vector<double>& ranges, double low, double high) {
  std::size_t count = 0;
  for (const double range : ranges) count += range >= low && range <= high ? 1 : 0;
  return static_cast<double>(count) / static_cast<double>(ranges.size());
}

// Five standard errors of a fraction p of kBeams.
double fraction_bound(double p) {
  return 5.0 * std::sqrt(p * (1.0 - p) / kBeams);
}

TEST(LaserNoise, WithEverythingOffTheReadingIsTheRange) {
  for (const double range : readings({wall_at(3.25F)}, noiseless_laser())) EXPECT_EQ(range, 3.25);
}

TEST(LaserNoise, HasTheBiasAndSigmaThatWereAskedFor) {
  MountedLaser laser = noiseless_laser();
  laser.model.noise.sigma_near = 0.005;
  laser.model.noise.sigma_far = 0.02;
  laser.model.noise.near_range = 8.0;
  laser.model.noise.far_range = 20.0;
  laser.model.noise.bias = 0.013;
  for (const auto& [range, sigma] : {std::pair{4.0, 0.005}, {14.0, 0.0125}, {30.0, 0.02}}) {
    const std::vector<double> ranges = readings({wall_at(static_cast<float>(range))}, laser);
    EXPECT_NEAR(mean_of(ranges), range + 0.013, 5 * sigma / std::sqrt(kBeams));
    EXPECT_NEAR(sigma_of(ranges), sigma, 5 * sigma / std::sqrt(2.0 * kBeams));
  }
}

TEST(LaserNoise, ReadsWholeSteps) {
  MountedLaser laser = noiseless_laser();
  laser.model.noise.sigma_near = 0.01;
  laser.model.noise.step = 0.01;
  const std::vector<double> ranges = readings({wall_at(3.0F)}, laser);
  for (const double range : ranges) {
    EXPECT_NEAR(range / 0.01, std::round(range / 0.01), 1e-9);
  }
  // Sheppard: the steps add their own variance step^2 / 12.
  const double sigma = std::sqrt(0.01 * 0.01 * (1.0 + 1.0 / 12.0));
  EXPECT_NEAR(sigma_of(ranges), sigma, 5 * sigma / std::sqrt(2.0 * kBeams));
}

TEST(LaserNoise, NothingInReachReadsMaxRange) {
  for (const double range : readings({wall_at(kNothing)}, noiseless_laser())) {
    EXPECT_EQ(range, 80.0);
  }
  for (const double range : readings({wall_at(90.0F)}, noiseless_laser())) EXPECT_EQ(range, 80.0);
}

TEST(LaserNoise, MissesShortAndRandomReadingsComeAsOftenAsAskedFor) {
  MountedLaser laser = noiseless_laser();
  laser.model.noise.miss_probability = 0.1;
  laser.model.noise.short_probability = 0.2;
  laser.model.noise.random_probability = 0.05;
  const std::vector<double> ranges = readings({wall_at(20.0F)}, laser);

  const double missed = 0.95 * 0.1;
  const double is_short = 0.95 * 0.9 * 0.2;
  const double wall = 0.95 * 0.9 * 0.8;
  EXPECT_NEAR(fraction_of(ranges, 80.0, 80.0), missed, fraction_bound(missed));
  EXPECT_NEAR(fraction_of(ranges, 20.0, 20.0), wall, fraction_bound(wall));
  const double before = is_short + 0.05 * 20.0 / 80.0;  // random ones fall there too
  EXPECT_NEAR(fraction_of(ranges, 0.0, 19.999), before, fraction_bound(before));
}

TEST(LaserNoise, ADarkSurfaceIsSeenHalfTheTimeAtItsLimit) {
  MountedLaser laser = noiseless_laser();
  laser.model.noise.dark_range = 10.0;
  laser.model.noise.dark_softness = 0.1;
  const Echo head_on{.range = 10.0F, .reflectivity = 0.1F};
  EXPECT_NEAR(fraction_of(readings({head_on}, laser), 9.9, 10.1), 0.5, fraction_bound(0.5));

  // The limit goes with the root of reflectivity times cosine: 10 m sqrt(0.4 * 0.25 / 0.1).
  const Echo slanted{.range = 10.0F, .reflectivity = 0.4F, .cos_incidence = 0.25F};
  EXPECT_NEAR(fraction_of(readings({slanted}, laser), 9.9, 10.1), 0.5, fraction_bound(0.5));

  // Four times the standard remission is seen twice as far.
  const Echo bright{.range = 20.0F, .reflectivity = 0.4F};
  EXPECT_NEAR(fraction_of(readings({bright}, laser), 19.9, 20.1), 0.5, fraction_bound(0.5));

  // One sigma of the limit nearer: Phi(1).
  const Echo nearer{.range = static_cast<float>(10.0 * std::exp(-0.1)), .reflectivity = 0.1F};
  EXPECT_NEAR(fraction_of(readings({nearer}, laser), 8.0, 10.0), 0.8413, fraction_bound(0.8413));
}

TEST(LaserNoise, GlassAnswersByChanceElseTheBeamGoesOn) {
  const std::vector<Echo> pane_and_wall = {
      {.range = 2.0F, .reflectivity = 0.5F, .hit_probability = 0.3F}, wall_at(5.0F)};
  MountedLaser laser = noiseless_laser();
  const std::vector<double> ranges = readings(pane_and_wall, laser);
  EXPECT_NEAR(fraction_of(ranges, 2.0, 2.0), 0.3, fraction_bound(0.3));
  EXPECT_NEAR(fraction_of(ranges, 5.0, 5.0), 0.7, fraction_bound(0.7));

  laser.model.noise.glass = false;
  EXPECT_EQ(fraction_of(readings(pane_and_wall, laser), 2.0, 2.0), 1.0);
}

// A pane behind a pane answers by its own chance: of what the first one lets through.
TEST(LaserNoise, EachPaneOnTheWayAnswersByItsOwnChance) {
  Echo first = wall_at(2.0F), second = wall_at(3.0F);
  first.hit_probability = second.hit_probability = 0.3F;
  const std::vector<double> ranges = readings({first, second, wall_at(5.0F)}, noiseless_laser());
  EXPECT_NEAR(fraction_of(ranges, 2.0, 2.0), 0.3, fraction_bound(0.3));
  EXPECT_NEAR(fraction_of(ranges, 3.0, 3.0), 0.7 * 0.3, fraction_bound(0.21));
  EXPECT_NEAR(fraction_of(ranges, 5.0, 5.0), 0.7 * 0.7, fraction_bound(0.49));
}

class OnAnEdge : public ::testing::Test {
 protected:
  // 40 % of the spot on something 2 m away, 60 % on something `gap` behind it, equally bright.
  static std::vector<Echo> edge(float gap) {
    return {{.range = 2.0F, .reflectivity = 0.5F, .fraction = 0.4F, .sub_ray = 0},
            {.range = 2.0F + gap, .reflectivity = 0.5F, .fraction = 0.6F, .sub_ray = 1}};
  }
  // Received power goes with 1 / range^2.
  static double near_weight(double gap) {
    const double near = 0.4 / 4.0;
    const double far = 0.6 / ((2.0 + gap) * (2.0 + gap));
    return near / (near + far);
  }
};

TEST_F(OnAnEdge, WeightedReadsTheMeanByPower) {
  MountedLaser laser = noiseless_laser();
  laser.model.noise.mixed_pixels = MixedPixels::weighted;
  const double expected = 2.0 + (1.0 - near_weight(2.0)) * 2.0;
  for (const double range : readings(edge(2.0F), laser)) EXPECT_NEAR(range, expected, 1e-6);
}

TEST_F(OnAnEdge, EitherReadsOneOfThemByPower) {
  MountedLaser laser = noiseless_laser();
  laser.model.noise.mixed_pixels = MixedPixels::either;
  const std::vector<double> ranges = readings(edge(2.0F), laser);
  const double near = near_weight(2.0);
  EXPECT_NEAR(fraction_of(ranges, 1.999, 2.001), near, fraction_bound(near));
  EXPECT_NEAR(fraction_of(ranges, 3.999, 4.001), 1.0 - near, fraction_bound(near));
}

TEST_F(OnAnEdge, APulseMeltsCloseEchoesAndTellsFarOnesApart) {
  MountedLaser laser = noiseless_laser();
  laser.model.noise.mixed_pixels = MixedPixels::pulse;
  laser.model.noise.pulse_length = 0.45;
  EXPECT_EQ(fraction_of(readings(edge(0.25F), laser), 2.05, 2.2), 1.0);
  const double near = near_weight(1.0);
  EXPECT_NEAR(fraction_of(readings(edge(1.0F), laser), 1.999, 2.001), near, fraction_bound(near));
}

TEST_F(OnAnEdge, OffReadsWhatTheAxisMeets) {
  MountedLaser laser = noiseless_laser();
  laser.model.noise.mixed_pixels = MixedPixels::off;
  for (const double range : readings(edge(1.0F), laser)) EXPECT_EQ(range, 3.0);
}

TEST(LaserNoise, ABeamsDrawsDependOnNothingButItsOwnPlace) {
  MountedLaser laser = noiseless_laser();
  laser.model.noise.sigma_near = 0.01;
  laser.model.noise.miss_probability = 0.01;
  const IdealScan empty = equal_beams({wall_at(3.0F)});
  IdealScan with_person = empty;
  with_person.echoes[17] = wall_at(1.0F);  // somebody steps into beam 17

  const LaserScan before = with_noise(empty, laser, Rng(1));
  const LaserScan after = with_noise(with_person, laser, Rng(1));
  for (std::size_t k = 0; k < before.ranges.size(); ++k) {
    if (k == 17) continue;
    ASSERT_EQ(before.ranges[k], after.ranges[k]);
  }
  EXPECT_NEAR(after.ranges[17] - before.ranges[17], -2.0, 1e-9);  // even its own error is the same
}

TEST(LaserNoise, WhatIsNearerThanItsLeastRangeFails) {
  MountedLaser laser = noiseless_laser();
  laser.model.min_range = 0.5;
  for (const double range : readings({wall_at(0.4F)}, laser)) EXPECT_EQ(range, 0.0);
  for (const double range : readings({wall_at(0.6F)}, laser)) EXPECT_NEAR(range, 0.6, 1e-6);
}

// Each device has an error of its own for a whole run; those of many have the sigma asked for.
TEST(LaserNoise, DevicesDifferByBiasAndScale) {
  MountedLaser laser = noiseless_laser();
  laser.model.beams = 2;
  laser.model.noise.bias_spread = 0.02;
  laser.model.noise.scale_spread = 0.01;
  std::vector<double> errors;
  for (std::uint64_t run = 0; run < 400; ++run) {
    IdealScan scan;
    scan.first_echo = {0, 1, 2};
    scan.echoes = {wall_at(2.0F), wall_at(6.0F)};
    const LaserScan first = with_noise(scan, laser, Rng(run));
    scan.sweep = 7;
    EXPECT_EQ(with_noise(scan, laser, Rng(run)).ranges, first.ranges);
    errors.push_back(first.ranges[1] - 6.0);
    const DeviceError device = device_error(laser.model.noise, 0, Rng(run));
    EXPECT_NEAR(first.ranges[0], 2.0 * device.scale + device.bias, 1e-9);
  }
  const double sigma = std::hypot(0.02, 0.06);  // at 6 m
  EXPECT_NEAR(mean_of(errors), 0.0, 5.0 * sigma / std::sqrt(400.0));
  EXPECT_NEAR(sigma_of(errors), sigma, 5.0 * sigma / std::sqrt(800.0));
}

// A reading of 0 would mean that the beam failed.
TEST(LaserNoise, WhatIsTooNearReadsTheLeastThereIs) {
  MountedLaser laser = noiseless_laser();
  laser.model.noise.step = 0.01;
  for (const double range : readings({wall_at(0.002F)}, laser)) EXPECT_EQ(range, 0.01);
  laser.model.noise.step = 0.0;
  laser.model.noise.bias = -1.0;
  for (const double range : readings({wall_at(0.5F)}, laser)) EXPECT_EQ(range, 0.001);
}

}  // namespace
}  // namespace mapbed
