#include "algorithms/dynamic_em/cause_map.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/dynamic_em/beam_expectation.h"
#include "algorithms/grid/beam_likelihood.h"
#include "core/testing/test_room.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

// Looks of one beam along a row of cells of 1 m, from the middle of the first one: `hits` of them
// end in the fourth cell, the others pass it and end in the eighth.
struct Looks {
  SensorLog log;
  Trajectory path;
};

Looks looks_along_a_row(int hits, int passes) {
  Looks looks;
  for (int i = 0; i < hits + passes; ++i) {
    LaserScan scan;
    scan.time = i;
    scan.max_range = 20.0;
    scan.ranges = {i < hits ? 3.0 : 7.0};
    looks.log.emplace_back(scan);
    looks.path.push_back({scan.time, {0.5, 0.5, 0.0}});
  }
  return looks;
}

CauseMap map_of(const Looks& looks, double p) {
  return {looks.log, looks.path, {.p_static = p, .resolution = 1.0, .least_m = 1e-9}};
}

double m_at(const CauseMap& map, int x) {
  return map.occupancy()[{x, 0}].probability;
}

TEST(CauseMap, BeginsWithEveryExpectationAtItsPrior) {
  // alpha = 3 p; beta = 3 (1 - p) + 7
  EXPECT_NEAR(m_at(map_of(looks_along_a_row(3, 7), 0.8), 3), 3 * 0.8 / 10.0, 1e-6);
}

struct Share {
  int hits, passes;
  double p;
};

class ACell : public ::testing::TestWithParam<Share> {};

// (p r - (1 - p)) / (2 p - 1), or 0, by solving e(m) = (4.10), m = r e.
TEST_P(ACell, SettlesByTheFractionThatItReflects) {
  const auto [hits, passes, p] = GetParam();
  CauseMap map = map_of(looks_along_a_row(hits, passes), p);
  for (int i = 0; i < 2000; ++i) map.step();
  const double r = static_cast<double>(hits) / (hits + passes);
  EXPECT_NEAR(m_at(map, 3), std::max(0.0, (p * r - (1 - p)) / (2 * p - 1)), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(OfManyKinds, ACell,
                         ::testing::Values(Share{10, 0, 0.8}, Share{9, 1, 0.8}, Share{5, 5, 0.9},
                                           Share{3, 7, 0.9}, Share{1, 9, 0.8}, Share{1, 19, 0.95},
                                           Share{4, 6, 0.6}));

TEST(CauseMap, WhatNoBeamEverPassedIsStatic) {
  Looks looks = looks_along_a_row(3, 7);
  CauseMap map = map_of(looks, 0.9);
  for (int i = 0; i < 50; ++i) map.step();
  const BeamLabels labels = map.labels(looks.log, looks.path);
  EXPECT_FALSE(is_dynamic(labels[9], 0)) << "the wall at the end of the row";
  EXPECT_NEAR(labels[9].static_probability[0], 1.0, 1e-6);
}

TEST(CauseMap, WhatBeamsMostlyPassedIsDynamicAndAMaximumRangeBeamHasNoLabel) {
  Looks looks = looks_along_a_row(1, 30);
  std::get<LaserScan>(looks.log.back()).ranges = {20.0};
  CauseMap map = map_of(looks, 0.9);
  for (int i = 0; i < 10; ++i) map.step();
  const BeamLabels labels = map.labels(looks.log, looks.path);
  EXPECT_TRUE(is_dynamic(labels.front(), 0));
  EXPECT_TRUE(std::isnan(labels.back().static_probability[0]));
}

TEST(CauseMap, RefusesAPriorThatWouldEmptyEveryPlaceThatWasSeenThrough) {
  const Looks looks = looks_along_a_row(1, 1);
  EXPECT_INPUT_ERROR(map_of(looks, 0.5), "p_static 0.5 is not between 0.5 and 1");
  EXPECT_INPUT_ERROR(map_of(looks, 1.0), "p_static 1 is not");
}

// A drive through a room with a table that is there in one of 16 scans.
class OnADrive : public ::testing::Test {
 protected:
  OnADrive() {
    TestRoom room = rectangular_room(6.0, 4.0);
    const RecordedLog empty = drive_through(room, {{-1.5, 0.0}, {1.5, 0.6}}, {}, Rng(1));
    room.add_box({1.0, -1.0}, 0.4, 0.4);
    const RecordedLog full = drive_through(room, {{-1.5, 0.0}, {1.5, 0.6}}, {}, Rng(1));
    for (std::size_t i = 0; i < empty.measurements.size(); ++i) {
      log_.push_back(i % 32 < 2 ? full.measurements[i] : empty.measurements[i]);
    }
    path_ = empty.true_poses;
  }

  SensorLog log_;
  Trajectory path_;
};

TEST_F(OnADrive, NoStepLowersTheMarginalLikelihood) {
  for (const double p : {0.55, 0.7, 0.9, 0.99}) {
    CauseMap map(log_, path_, {.p_static = p});
    double before = map.marginal_log_likelihood();
    const double first = before;
    for (int i = 0; i < 40; ++i) {
      map.step();
      const double now = map.marginal_log_likelihood();
      // Rounding of e to float moves each of 10 000 terms by at most 1e-7 of its slope near 1.
      EXPECT_GE(now, before - 1e-3) << "p " << p << ", step " << i;
      before = now;
    }
    EXPECT_GT(before, first) << p;
  }
}

// The sums over cells against those over beams, one by one, with the map as others see it.
TEST_F(OnADrive, LikelihoodsAreThoseOfTheBeamsOneByOne) {
  constexpr double kP = 0.8;
  CauseMap map(log_, path_, {.p_static = kP});
  map.step();
  const OccupancyMap m = map.occupancy();
  double expected = 0.0, marginal = 0.0;
  auto pose = path_.begin();
  CauseMap before(log_, path_, {.p_static = kP});
  const OccupancyMap m_before = before.occupancy();
  for (const Measurement& measurement : log_) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr) continue;
    for_each_beam(*scan, (pose++)->pose, {}, [&](std::size_t, const Beam& beam) {
      const BeamTerms terms = beam_terms(beam, m);
      const double e = expectation_of_cause(beam_terms(beam, m_before), beam.hit, kP);
      expected += expected_log_likelihood(terms, beam.hit, e);
      if (beam.hit) expected += expected_log_prior(e, kP);
      marginal += terms.log_path;
      if (beam.hit) marginal += std::log(kP * terms.m_end + (1 - kP) * (1 - terms.m_end));
    });
  }
  EXPECT_NEAR(map.expected_log_likelihood(), expected, 1e-4 * std::abs(expected));
  EXPECT_NEAR(map.marginal_log_likelihood(), marginal, 1e-4 * std::abs(marginal));
}

TEST_F(OnADrive, TheTableFadesAndTheWallsStay) {
  CauseMap map(log_, path_, {.p_static = 0.9});
  for (int i = 0; i < 20; ++i) map.step();
  const BeamLabels labels = map.labels(log_, path_);
  int of_walls = 0, walls_lost = 0, of_table = 0, table_kept = 0;
  const TestRoom walls = rectangular_room(6.0, 4.0);
  std::size_t i = 0;
  for (const Measurement& measurement : log_) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr) continue;
    const LaserScan of_room = scan_of(walls, path_[i].pose);
    for (std::size_t n = 0; n < scan->ranges.size(); ++n) {
      const bool is_table = scan->ranges[n] < of_room.ranges[n] - 0.2;
      ++(is_table ? of_table : of_walls);
      if (is_dynamic(labels[i], n) != is_table) ++(is_table ? table_kept : walls_lost);
    }
    ++i;
  }
  ASSERT_GT(of_table, 20);
  EXPECT_LT(walls_lost, 0.03 * of_walls);
  EXPECT_LT(table_kept, 0.1 * of_table);
}

}  // namespace
}  // namespace mapbed
