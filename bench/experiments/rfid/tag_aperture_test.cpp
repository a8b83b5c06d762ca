#include "bench/experiments/rfid/tag_aperture.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr double kFrequency = 915e6;                        // [Hz]
constexpr double kWavelength = 299'792'458.0 / kFrequency;  // [m]

// Past the tag on two sides of a corner; the antenna is 0.6 m high, the tag 1.2 m.
SensorLog answers_of(const Eigen::Vector2d& tag, bool with_phase, Trajectory& path) {
  SensorLog log;
  const auto hear_from = [&](double x, double y) {
    RfidDetections round;
    round.time = 0.1 * static_cast<double>(log.size());
    round.frequency = kFrequency;
    round.robot_from_antenna.z = 0.6;
    const double distance = std::hypot((Eigen::Vector2d(x, y) - tag).norm(), 0.6);
    const double phase = 4.0 * kPi * distance / kWavelength + 0.9;
    round.reads.push_back({"a", -50.0, with_phase ? phase : RfidRead::kNotTold});
    path.push_back({round.time, {x, y, 0.0}});
    log.emplace_back(round);
  };
  for (double x = 0.0; x < 2.5; x += 0.05) hear_from(x, 0.0);
  for (double y = 0.0; y < 2.0; y += 0.05) hear_from(2.5, y);
  return log;
}

TEST(TagAperture, PutsATagWhereThePhasesOfItsAnswersAgree) {
  const Eigen::Vector2d tag(1.3, 1.4);
  Trajectory path;
  const SensorLog log = answers_of(tag, true, path);
  const TagBelief belief{"a", {{1.7, 1.1}}, {1.0}};  // half a metre off
  const auto places = by_phases({belief}, posed_rounds(log, path), {});
  ASSERT_TRUE(places.contains("a"));
  EXPECT_LT((places.at("a") - tag).norm(), 0.02);
}

TEST(TagAperture, WithoutPhasesThereIsNoPlace) {
  Trajectory path;
  const SensorLog log = answers_of({1.3, 1.4}, false, path);
  EXPECT_TRUE(by_phases({{"a", {{1.3, 1.4}}, {1.0}}}, posed_rounds(log, path), {}).empty());
}

}  // namespace
}  // namespace mapbed
