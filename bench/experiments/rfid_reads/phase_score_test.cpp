#include "bench/experiments/rfid_reads/phase_score.h"

#include <cmath>

#include <gtest/gtest.h>

#include "bench/experiments/rfid_reads/held_out_places.h"
#include "core/geometry/angle.h"
#include "core/random.h"

namespace mapbed {
namespace {

constexpr double kFrequency = 866e6;                        // [Hz]
constexpr double kWavelength = 299'792'458.0 / kFrequency;  // [m]
const std::vector<Eigen::Vector3d> kShifts{{0.06, -0.03, 0.0}, {-0.05, 0.02, 0.04}};

enum class Phases { by_the_way, by_the_way_of_shifted_tags, by_chance };

// Two antennas, two tags, 75 places, four reads each with noise of 0.3 rad; every second one is
// half a turn off.
PlacedReads reads_of(Phases kind) {
  PlacedReads reads{.tags = {"A", "B"}, .antennas = 2};
  Rng rng(21);
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      for (const double z : {0.5, 1.5, 2.5}) {
        const Eigen::Vector3d place(x, y, z);
        for (int antenna = 0; antenna < 2; ++antenna) {
          for (int tag = 0; tag < 2; ++tag) {
            Eigen::Vector3d at = place;
            if (kind == Phases::by_the_way_of_shifted_tags)
              at += kShifts[static_cast<std::size_t>(tag)];
            double mean = 4.0 * kPi * at.norm() / kWavelength + antenna + 2.0 * tag;
            if (kind == Phases::by_chance) mean = rng.uniform(-kPi, kPi);
            for (int i = 0; i < 4; ++i) {
              PlacedRead read{static_cast<int>(reads.places.size()), antenna, tag, kFrequency};
              read.phase = {normalized_angle(mean + kPi * (i % 2) + rng.normal(0.0, 0.3)), 0.0};
              reads.reads.push_back(read);
            }
          }
        }
        reads.places.push_back(place);
      }
    }
  }
  PlacedRead without_carrier{.place = 0};
  reads.reads.push_back(without_carrier);
  return reads;
}

PhaseScore score_of(Phases kind, const PhaseShiftOptions& shifts, int turns,
                    PhaseWay way = PhaseWay::there_and_back) {
  const PlacedReads reads = reads_of(kind);
  const std::vector<int> folds = folds_of(reads.places, {.folds = 3}, Rng(1));
  return held_out_score(phase_cells(reads, 1, turns), 2, 2, folds, shifts, way, turns);
}

// The mean cosine of twice a normal angle of 0.3 rad is exp(-0.6^2 / 2) = 0.835.
constexpr double kCosine = 0.835;

TEST(PhaseCells, HaveTheirReadsMeanAndLeaveOutThoseWithoutCarrier) {
  const PlacedReads reads = reads_of(Phases::by_the_way);
  const auto cells = phase_cells(reads, 1, 2);
  ASSERT_EQ(cells.size(), 300U);
  double size = 0.0;
  for (const PhaseCell& cell : cells) {
    EXPECT_EQ(cell.reading.reads, 4.0);
    EXPECT_NEAR(cell.reading.wavelength, kWavelength, 1e-12);
    size += std::norm(cell.reading.mean) / 300.0;
  }
  // Of four independent ones: (1 + 3 R^2) / 4, whose spread over cells is below 0.2.
  EXPECT_NEAR(size, 0.25 + 0.75 * kCosine * kCosine, 4.0 * 0.2 / std::sqrt(300.0));
  // Half a turn off and on again nothing is left but for the doubled phase.
  double single = 0.0;
  for (const PhaseCell& cell : phase_cells(reads, 1, 1))
    single += std::abs(cell.reading.mean) / 300.0;
  EXPECT_LT(single, 0.3);
}

TEST(PhaseScore, OfPhasesByTheWayIsTheirNoise) {
  const PhaseScore score = score_of(Phases::by_the_way, {}, 2);
  EXPECT_NEAR(score.agreement, kCosine, 0.03);
  EXPECT_NEAR(score.training_agreement, kCosine, 0.03);
  EXPECT_NEAR(score.gain, log_von_mises(kCosine, kappa_of(kCosine)) + std::log(2.0 * kPi), 0.05);
  EXPECT_GT(neighbours_agree(phase_cells(reads_of(Phases::by_the_way), 1, 2),
                             PhaseWay::there_and_back, 2),
            0.75);
  // Neither by the other sign, nor without the way, nor where half turns are taken for whole ones.
  EXPECT_LT(score_of(Phases::by_the_way, {}, 2, PhaseWay::nothing).agreement, 0.2);
  EXPECT_LT(score_of(Phases::by_the_way, {}, 1).agreement, 0.2);
}

TEST(PhaseScore, TagsBesideTheirBlocksMiddleAreFound) {
  const Phases kind = Phases::by_the_way_of_shifted_tags;
  EXPECT_LT(score_of(kind, {}, 2).agreement, 0.5);
  const PhaseScore score = score_of(kind, {.tags = true, .reach = 0.08}, 2);
  EXPECT_NEAR(score.agreement, kCosine, 0.04);
  EXPECT_NEAR(score.tag_shift, 0.5 * (kShifts[0].norm() + kShifts[1].norm()), 0.01);
  EXPECT_LT(score.repeated, 0.01);
}

// Of 300 cells by chance a mean cosine is 0 within 4 sqrt(0.5 / 300); kappa is then small or none,
// and nothing is lost for long. Tags sought among them agree in training alone.
TEST(PhaseScore, OfPhasesByChanceIsNothing) {
  const PhaseScore score = score_of(Phases::by_chance, {}, 2);
  EXPECT_NEAR(score.agreement, 0.0, 0.16);
  EXPECT_NEAR(score.gain, 0.0, 0.02);
  const PhaseScore sought = score_of(Phases::by_chance, {.tags = true, .reach = 0.1}, 2);
  EXPECT_GT(sought.training_agreement, score.training_agreement);
  EXPECT_NEAR(sought.agreement, 0.0, 0.16);
}

}  // namespace
}  // namespace mapbed
