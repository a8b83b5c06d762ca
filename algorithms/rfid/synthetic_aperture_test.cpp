#include "algorithms/rfid/synthetic_aperture.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/random.h"

namespace mapbed {
namespace {

constexpr double kWavelength = 299'792'458.0 / 915e6;  // [m]

// Along two sides of a corner, each channel with an offset of its own.
std::vector<PhaseRead> drive_past(const Eigen::Vector3d& tag, double noise, double drift = 0.0) {
  std::vector<PhaseRead> reads;
  Rng rng(7);
  const auto read_at = [&](double x, double y, double along) {
    for (int channel = 0; channel < 2; ++channel) {
      const Eigen::Vector3d antenna(x, y + 0.2 * channel, 1.0);
      const Eigen::Vector3d believed =
          antenna + Eigen::Vector3d(0.0, drift * std::sin(3.0 * along), 0.0);
      const double phase = 4.0 * kPi * (tag - antenna).norm() / kWavelength + 1.7 * channel;
      reads.push_back({believed, phase + rng.normal(0.0, noise), kWavelength, channel});
    }
  };
  for (double x = 0.0; x < 3.0; x += 0.05) read_at(x, 0.0, x);
  for (double y = 0.0; y < 2.0; y += 0.05) read_at(3.0, y, 3.0 + y);
  return reads;
}

const Eigen::AlignedBox3d kBox(Eigen::Vector3d(0.5, 1.0, 1.3), Eigen::Vector3d(2.5, 3.0, 1.3));

TEST(SyntheticAperture, FindsATagToAFewMillimetres) {
  const Eigen::Vector3d tag(1.37, 2.12, 1.3);
  const ApertureAnswer answer = focused(drive_past(tag, 0.0), kBox);
  EXPECT_LT((answer.position - tag).norm(), 0.006);
  EXPECT_GT(answer.agreement, 0.98);
}

TEST(SyntheticAperture, AllPhasesAgreeAtTheTagAloneWhateverTheOffsetsAre) {
  const Eigen::Vector3d tag(1.37, 2.12, 1.3);
  const auto reads = drive_past(tag, 0.0);
  EXPECT_NEAR(phase_agreement(reads, tag), 1.0, 1e-9);
  EXPECT_LT(phase_agreement(reads, tag + Eigen::Vector3d(0.15, 0.0, 0.0)), 0.7);
  EXPECT_LT(phase_agreement(reads, tag + Eigen::Vector3d(0.0, 0.3, 0.0)), 0.7);
}

TEST(SyntheticAperture, NoiseOfATenthOfATurnIsAveragedOut) {
  const Eigen::Vector3d tag(1.8, 1.6, 1.3);
  const ApertureAnswer answer = focused(drive_past(tag, 0.6), kBox);
  EXPECT_LT((answer.position - tag).norm(), 0.03);
}

TEST(SyntheticAperture, APathThatIsOffByAnEighthOfAWavelengthBlursIt) {
  const Eigen::Vector3d tag(1.37, 2.12, 1.3);
  const double straight = focused(drive_past(tag, 0.0), kBox).agreement;
  const double bent = focused(drive_past(tag, 0.0, 0.04), kBox).agreement;
  EXPECT_LT(bent, straight - 0.1);
}

TEST(SyntheticAperture, NothingHeardIsNoPlace) {
  EXPECT_EQ(focused({}, kBox).reads, 0);
  EXPECT_EQ(phase_agreement({}, {}), 0.0);
}

}  // namespace
}  // namespace mapbed
