#include "sim/recording.h"

#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

constexpr std::size_t kMost = 100'000;  // [bytes]
constexpr std::size_t kItems = 1000;    // of all kinds, each of at least 20 bytes
constexpr const char* kMessage = "takes more than 0.0001 GB of memory; choose fewer beams";

IdealScan scan_of(std::size_t echoes) {
  return {.echoes = std::vector<Echo>(echoes),
          .first_echo = {0, static_cast<std::uint32_t>(echoes)}};
}

TEST(Recording, KeepsWhatFitsIntoItsMemory) {
  Recording recording;
  const RecordingSink sink = sink_into(recording, kMost);
  sink.reading(IdealOdometry{.time = 1.0});
  sink.reading(scan_of(kItems));
  sink.states({.time = 2.0, .moving = std::vector<MovingPose>(10)});
  sink.beams({.time = 3.0, .beams = std::vector<BeamTruth>(kItems)});
  ASSERT_EQ(recording.readings.size(), 2u);
  EXPECT_EQ(std::get<IdealScan>(recording.readings[1]).echoes.size(), kItems);
  EXPECT_EQ(recording.truth.states.at(0).moving.size(), 10u);
  EXPECT_EQ(recording.truth.beams.at(0).beams.size(), kItems);
}

// However it is filled: what it is told of counts, before it is kept.
TEST(Recording, IsRefusedWhereItTakesMoreMemoryThanWasAllowed) {
  Recording recording;
  RecordingSink sink = sink_into(recording, kMost);
  EXPECT_INPUT_ERROR(sink.reading(scan_of(kMost / sizeof(Echo))), kMessage);
  EXPECT_TRUE(recording.readings.empty());
  sink = sink_into(recording, kMost);
  EXPECT_INPUT_ERROR(sink.states({.moving = std::vector<MovingPose>(kMost / sizeof(MovingPose))}),
                     kMessage);
  sink = sink_into(recording, kMost);
  EXPECT_INPUT_ERROR(sink.beams({.beams = std::vector<BeamTruth>(kMost / sizeof(BeamTruth))}),
                     kMessage);
  sink = sink_into(recording, kMost);
  const auto odometry = [&] {
    for (std::size_t i = 0; i < kMost / sizeof(IdealReading) + 1; ++i)
      sink.reading(IdealOdometry{});
  };
  EXPECT_INPUT_ERROR(odometry(), kMessage);
}

TEST(Recording, AllKindsShareItsMemory) {
  Recording recording;
  const RecordingSink sink = sink_into(recording, kMost);
  sink.reading(scan_of(kMost / sizeof(Echo) / 2));
  EXPECT_INPUT_ERROR(sink.beams({.beams = std::vector<BeamTruth>(kMost / sizeof(BeamTruth) / 2)}),
                     kMessage);
}

}  // namespace
}  // namespace mapbed
