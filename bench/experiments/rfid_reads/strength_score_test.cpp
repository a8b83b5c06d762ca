#include "bench/experiments/rfid_reads/strength_score.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <gmock/gmock.h>

#include "bench/experiments/rfid_reads/held_out_places.h"
#include "bench/experiments/rfid_reads/place_search.h"
#include "core/random.h"

namespace mapbed {
namespace {

StrengthModel known_model() {
  StrengthModel model;
  for (int i = 0; i < 4; ++i) {
    SpatialAntenna a;
    a.azimuth = radians(90.0 * i);
    a.elevation = radians(45.0);
    a.falloff = 25.0;
    model.antennas.push_back(a);
  }
  model.tags = {1.0, -1.0};
  return model;
}

// On a lattice of 1 m: five reads by each antenna of each tag at each place, with this noise, and
// what fades at a place for all of them.
PlacedReads reads_of(const StrengthModel& model, double noise, double fading) {
  PlacedReads reads{.tags = {"A", "B"}, .antennas = 4};
  Rng rng(11);
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      for (const double z : {0.5, 1.5, 2.5}) {
        const Eigen::Vector3d place(x, y, z);
        for (int antenna = 0; antenna < 4; ++antenna) {
          for (int tag = 0; tag < 2; ++tag) {
            const double mean =
                expected_strength(model, antenna, tag, place) + rng.normal(0.0, fading);
            for (int i = 0; i < 5; ++i) {
              PlacedRead read{static_cast<int>(reads.places.size()), antenna, tag, 866e6};
              read.strength = {mean + rng.normal(0.0, noise), -90.0};
              reads.reads.push_back(read);
            }
          }
        }
        reads.places.push_back(place);
      }
    }
  }
  return reads;
}

TEST(HeldOutPlaces, EachIsHeldOutOnceAndFoldsAreEven) {
  const PlacedReads reads = reads_of(known_model(), 0.0, 0.0);
  for (const HeldOutUnit unit : {HeldOutUnit::places, HeldOutUnit::columns}) {
    const HeldOutOptions options{.folds = 5, .unit = unit};
    const std::vector<int> folds = folds_of(reads.places, options, Rng(1));
    std::map<int, int> counts;
    for (const int fold : folds) ++counts[fold];
    EXPECT_THAT(counts, ::testing::ElementsAre(std::pair(0, 15), std::pair(1, 15), std::pair(2, 15),
                                               std::pair(3, 15), std::pair(4, 15)));
    EXPECT_EQ(folds, folds_of(reads.places, options, Rng(1)));
    EXPECT_NE(folds, folds_of(reads.places, options, Rng(2)));
    if (unit == HeldOutUnit::places) continue;
    for (std::size_t i = 0; i < folds.size(); i += 3) {
      EXPECT_EQ(folds[i], folds[i + 1]);
      EXPECT_EQ(folds[i], folds[i + 2]);
    }
  }
}

// 600 cells with 4 freedoms each for the noise: 1.5 within 1.5 / sqrt(2 * 2400) times four. What
// fades at a place, an antenna and a tag by itself is left when places and tags are taken off: with
// two tags half of it, 1 / sqrt(2).
TEST(ReadMeans, TellNoiseFromFading) {
  const PlacedReads reads = reads_of(known_model(), 1.5, 4.0);
  const auto cells = strength_cells(reads, 1);
  ASSERT_EQ(cells.size(), 600U);
  EXPECT_EQ(cells[0].reads, 5.0);
  EXPECT_NEAR(noise_of(reads, 1), 1.5, 0.087);
  EXPECT_EQ(noise_of(reads, 2), 0.0);
  const double of_means = std::hypot(4.0, 1.5 / std::sqrt(5.0)) / std::sqrt(2.0);
  EXPECT_NEAR(spread_beside_places(cells), of_means, 4.0 * of_means / std::sqrt(2.0 * 300.0));
  EXPECT_NEAR(spread_beside_places(strength_cells(reads_of(known_model(), 0.0, 0.0), 1)), 0.0,
              1e-9);
  // Of reads -60 and -64 about -61: 1 + 9.
  StrengthCell cell{{0, 0, Eigen::Vector3d::Zero(), -62.0}, 0, 2.0, 8.0};
  EXPECT_NEAR(cell.squares_about(-61.0), 10.0, 1e-12);
}

TEST(PlaceSearch, FindsWhereKnownStrengthsComeFrom) {
  const StrengthModel model = known_model();
  StrengthMap map{
      [&](int antenna, const Eigen::Vector3d& at) { return link_budget(model, antenna, at); },
      model.tags,
      {},
      {}};
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-2.5, -2.5, 0.0), Eigen::Vector3d(2.5, 2.5, 3.0));
  const PlaceSearch search(map, 0.2, box, 0.1, 4);
  const Eigen::Vector3d truth(1.2, -0.7, 1.1);
  std::vector<StrengthReading> readings;
  for (int antenna = 0; antenna < 4; ++antenna) {
    readings.push_back({antenna, 0, truth, expected_strength(model, antenna, 0, truth)});
    readings.push_back({antenna, 1, truth, expected_strength(model, antenna, 1, truth)});
  }
  EXPECT_LT((search.place_of(readings) - truth).norm(), 0.05);
  // Of nothing, the middle of the box.
  EXPECT_LT((search.place_of({}) - box.center()).norm(), 1e-9);
}

TEST(PlaceSearch, TheMostAlikePlaceHasTheSameReadings) {
  const Eigen::Vector3d a(0.0, 0.0, 1.0), b(1.0, 0.0, 1.0), c(2.0, 0.0, 1.0);
  // At c antenna 1 does not hear the tag; what another tag did there says nothing.
  const std::vector<StrengthReading> measured{{0, 0, a, -60.0}, {1, 0, a, -70.0}, {0, 0, b, -66.0},
                                              {1, 0, b, -64.0}, {0, 0, c, -65.0}, {0, 1, c, -99.0},
                                              {1, 1, c, -99.0}};
  const auto found = [&](std::vector<StrengthReading> readings) {
    return most_alike(readings, measured);
  };
  EXPECT_EQ(found({{0, 0, Eigen::Vector3d::Zero(), -61.0}, {1, 0, Eigen::Vector3d::Zero(), -69.0}}),
            a);
  EXPECT_EQ(found({{0, 0, Eigen::Vector3d::Zero(), -65.0}, {1, 0, Eigen::Vector3d::Zero(), -66.0}}),
            b);
  EXPECT_EQ(found({{0, 0, Eigen::Vector3d::Zero(), -65.0}}), c);
}

// Noise and fading are all that is left of a model that is right: with 600 means, 2.04 within
// 4 / sqrt(1200) of itself, and a little for the 33 parameters that 480 of them gave.
TEST(StrengthScore, OfWhatMadeTheReadsIsTheirNoise) {
  const PlacedReads reads = reads_of(known_model(), 1.0, 2.0);
  const auto cells = strength_cells(reads, 1);
  const std::vector<int> folds = folds_of(reads.places, {}, Rng(4));
  const auto score_of = [&](StrengthPredictor predictor) {
    return held_out_score(cells, reads, folds, {.predictor = predictor}, {.step = 0.25});
  };
  const StrengthScore score = score_of(StrengthPredictor::link_budget);
  ASSERT_EQ(score.predictions.size(), 600U);
  ASSERT_EQ(score.blocks.size(), 75U);
  ASSERT_EQ(score.tags.size(), 150U);
  const double of_means = std::hypot(2.0, 1.0 / std::sqrt(5.0));
  const double likely = of_means * (1.0 + 0.5 * 33.0 / 480.0);
  EXPECT_NEAR(std::sqrt(score.squares), likely, of_means * 4.0 / std::sqrt(1200.0));
  // Entropy of a normal density of the reads' spread, the mean of it being known to a tenth.
  const double of_reads = std::hypot(2.0, 1.0) * (1.0 + 0.5 * 33.0 / 480.0);
  EXPECT_NEAR(score.log_likelihood, -0.5 - std::log(of_reads * std::sqrt(2.0 * kPi)), 0.1);
  EXPECT_GT(score.baseline_squares, 4.0 * score.squares);
  // Others say less; the mean of tag and antenna is what the score's baseline is.
  EXPECT_GT(score_of(StrengthPredictor::near_places).squares, score.squares);
  EXPECT_GT(score_of(StrengthPredictor::nearest_place).squares, score.squares);
  const StrengthScore baseline = score_of(StrengthPredictor::antenna_and_tag);
  EXPECT_NEAR(baseline.squares, baseline.baseline_squares, 1e-9);
  EXPECT_NEAR(baseline.squares, score.baseline_squares, 1e-9);
  const auto median_error = [](const StrengthScore& of) {
    std::vector<double> errors;
    for (const auto& block : of.blocks) errors.push_back((block.found - block.truth).norm());
    std::nth_element(errors.begin(), errors.begin() + 37, errors.end());
    return errors[37];
  };
  // 2 m away strengths change by some 5 dB a metre ahead and 4 aside: of eight readings with 2 dB
  // each axis is known to 2 / (5 sqrt(8 / 3)) = 0.25 m, and space to sqrt(3) times that.
  EXPECT_LT(median_error(score), 0.7);
  EXPECT_GT(median_error(baseline), 1.5);  // the middle, always
}

// Nothing of a place that is held out comes into what is said of it.
TEST(StrengthScore, WhatIsHeldOutIsNotLearnedFrom) {
  const PlacedReads reads = reads_of(known_model(), 0.0, 1.0);
  auto cells = strength_cells(reads, 1);
  const std::vector<int> folds = folds_of(reads.places, {}, Rng(4));
  const auto predicted = [&] {
    std::map<std::vector<int>, double> values;
    const StrengthScore score = held_out_score(
        cells, reads, folds, {.predictor = StrengthPredictor::near_places}, {.step = 1.0});
    for (const auto& p : score.predictions) {
      if (p.cell.place != 30) continue;
      values[{p.cell.reading.antenna, p.cell.reading.tag}] = p.strength;
    }
    return values;
  };
  const auto before = predicted();
  for (StrengthCell& cell : cells) {
    if (folds[static_cast<std::size_t>(cell.place)] == folds[30]) cell.reading.strength += 100.0;
  }
  EXPECT_EQ(predicted(), before);
}

}  // namespace
}  // namespace mapbed
