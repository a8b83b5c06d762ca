#include "algorithms/grid/odds_map.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/grid/testing/drawing.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

constexpr CellIndex kCell{2, 0};

// The cell (2, 0) after some beams ended in it and some went through.
Occupancy after(int c_occ, int c_free, const OddsModel& model) {
  OddsMap map(GridFrame{.resolution = 1.0}, model);
  for (int i = 0; i < c_occ; ++i) map.insert({{0.5, 0.5}, {2.5, 0.5}});
  for (int i = 0; i < c_free; ++i) map.insert({{0.5, 0.5}, {4.5, 0.5}});
  return map.occupancy()[kCell];
}

// One look after the other by (2.7), the odds multiplied, and back by (2.10).
double bayes(int c_occ, int c_free, const OddsModel& model) {
  const auto odds_of = [](double p) { return p / (1.0 - p); };
  double odds = odds_of(model.prior);
  for (int i = 0; i < c_occ; ++i) odds *= odds_of(model.p_occ) / odds_of(model.prior);
  for (int i = 0; i < c_free; ++i) odds *= odds_of(model.p_free) / odds_of(model.prior);
  return odds / (1.0 + odds);
}

TEST(OddsModel, TheClosedFormIsTheRepeatedBayesianUpdate) {  // (2.13) put right
  for (const OddsModel& model : {OddsModel{}, OddsModel{.p_occ = 0.7, .p_free = 0.4},
                                 OddsModel{.p_occ = 0.9, .p_free = 0.1, .prior = 0.3}}) {
    for (int c_occ = 0; c_occ <= 10; ++c_occ) {
      for (int c_free = 0; c_free <= 10; ++c_free) {
        EXPECT_NEAR(odds_occupancy(c_occ, c_free, model), bayes(c_occ, c_free, model), 1e-12);
      }
    }
  }
}

TEST(OddsModel, TheClosedFormFallsBelowOneHalf) {  // where the printed (2.13) cannot
  EXPECT_NEAR(odds_occupancy(0, 1), 0.2, 1e-15);
  EXPECT_NEAR(odds_occupancy(0, 2), 1.0 / 17.0, 1e-15);  // odds 1/4 * 1/4
  EXPECT_NEAR(odds_occupancy(3, 3), 0.5, 1e-15);
  const double printed = std::exp(2 * 0.2) / (1 + std::exp(2 * 0.2));
  EXPECT_GT(printed, 0.5);
}

TEST(OddsModel, TheClosedFormOfEndPointsStartsAtThePrior) {  // (2.16) put right
  const OddsModel model{.p_occ = 0.8, .p_free = 0.1, .prior = 0.3};
  EXPECT_NEAR(odds_occupancy(0, 0, model), 0.3, 1e-15);
  EXPECT_NEAR(odds_occupancy(1, 0, model), 0.8, 1e-15);
}

TEST(OddsMap, IsTheClosedFormCellByCell) {
  for (const OddsModel& model :
       {OddsModel{}, OddsModel{.p_occ = 0.7, .p_free = 0.2, .prior = 0.4}}) {
    for (int c_occ = 0; c_occ <= 6; ++c_occ) {
      for (int c_free = c_occ == 0 ? 1 : 0; c_free <= 6; ++c_free) {
        const Occupancy cell = after(c_occ, c_free, model);
        // Log odds of up to 12 are held in a float (rounded by 5e-7 at each of 12 looks), of which
        // a probability changes by a quarter at most.
        EXPECT_NEAR(cell.probability, odds_occupancy(c_occ, c_free, model), 2e-6);
      }
    }
  }
}

TEST(OddsMap, IsSureAfterSeventyOfAHundredLooks) {
  EXPECT_NEAR(after(70, 30, OddsModel{}).probability, 1.0, 1e-6);
}

TEST(OddsMap, ACellBackAtThePriorIsNotUnknown) {
  const Occupancy seen = after(1, 1, OddsModel{});
  EXPECT_TRUE(seen.known());
  EXPECT_NEAR(seen.probability, 0.5, 1e-6);
  EXPECT_FALSE(OddsMap(GridFrame{.resolution = 1.0}).occupancy()[kCell].known());
}

TEST(OddsMap, StaysWithinItsBoundsAndComesBackFromThem) {
  const OddsModel bounded{.lowest = 0.1, .highest = 0.9};
  EXPECT_NEAR(after(50, 0, bounded).probability, 0.9, 1e-6);
  EXPECT_NEAR(after(0, 50, bounded).probability, 0.1, 1e-6);
  // 50 hits, held at odds 9, then one miss of odds 1/4.
  EXPECT_NEAR(after(50, 1, bounded).probability, (9.0 / 4.0) / (1.0 + 9.0 / 4.0), 1e-6);
}

TEST(OddsMap, ABeamClearsItsPathAndFillsItsEnd) {
  OddsMap map(GridFrame{.resolution = 1.0});
  map.insert({{0.5, 0.5}, {4.5, 0.5}});
  map.insert({{0.5, 1.5}, {4.5, 1.5}, /*hit=*/false});
  EXPECT_EQ(drawing_of(map.occupancy(), {{0, 0}, {5, 1}}),
            "....  |"
            "....# |");
}

TEST(OddsModel, RefusesProbabilitiesThatContradictEachOther) {
  EXPECT_INPUT_ERROR(check(OddsModel{.p_occ = 0.5}), "0 < p_free < prior < p_occ < 1");
  EXPECT_INPUT_ERROR(check(OddsModel{.p_free = 0.0}), "0 < p_free");
  EXPECT_INPUT_ERROR(check(OddsModel{.p_occ = 1.0}), "p_occ < 1");
  EXPECT_INPUT_ERROR(check(OddsModel{.lowest = 0.6}), "lowest < prior < highest");
}

}  // namespace
}  // namespace mapbed
