#include "algorithms/rfid/learned_rfid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/file/text_file.h"
#include "core/input_error.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {
namespace {

HistogramAntenna small_histogram() {
  HistogramAntenna counted{.cell_size = 0.5, .cells = 2};
  counted.rounds = {4, 5, 6, 7};
  counted.detections = {1, 2, 3, 4};
  return counted;
}

TEST(LearnedRfid, IsReadAsItIsWritten) {
  const TemporaryFolder folder;
  const std::string path = folder.file("model.yaml");
  const LearnedRfid model{PiecewiseAntenna{.direction = 0.1, .range = 5.5, .caution = 1.0},
                          small_histogram(), SmoothAntenna{.level = 12.5, .rssi_sigma = 2.5}};
  write_text_file(path, to_yaml(model, "# learned\n"));
  const LearnedRfid read = load_learned_rfid(path);
  EXPECT_EQ(to_yaml(read, "# learned\n"), to_yaml(model, "# learned\n"));
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(kind_of(read[0]), "piecewise");
  EXPECT_EQ(kind_of(read[1]), "histogram");
  EXPECT_EQ(kind_of(read[2]), "smooth");
  EXPECT_EQ(std::get<PiecewiseAntenna>(read[0]).range, 5.5);
  EXPECT_EQ(std::get<HistogramAntenna>(read[1]).detections[3], 4.0);
  EXPECT_EQ(std::get<SmoothAntenna>(read[2]).level, 12.5);
}

std::string message_of(const std::string& text) {
  const TemporaryFolder folder;
  const std::string path = folder.file("model.yaml");
  write_text_file(path, text);
  try {
    (void)load_learned_rfid(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(LearnedRfid, WhatIsWrongIsTold) {
  using ::testing::HasSubstr;
  EXPECT_THAT(message_of("antennas:\n  - {kind: smoth}\n"), HasSubstr("smooth"));
  EXPECT_THAT(message_of("antennas: []\n"), HasSubstr("without antennas"));
  EXPECT_THAT(message_of("antennas:\n  - {kind: smooth, levl: 3}\n"), HasSubstr("levl"));
  EXPECT_THAT(
      message_of("antennas:\n  - {kind: histogram, cells: 2, rounds: [1], detections: [1]}\n"),
      HasSubstr("2 cells a side are 4 cells"));
  EXPECT_THAT(
      message_of("antennas:\n  - {kind: histogram, cells: 1, rounds: [1], detections: [2]}\n"),
      HasSubstr("more detections than rounds"));
  EXPECT_THROW(load_learned_rfid("nobody_learned_this"), InputError);
}

}  // namespace
}  // namespace mapbed
