#include "core/labels/labels_file.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

const BeamLabels kLabels{{976052857.25, 0, {1.0F, kNoLabel, 0.07F, 0.5F, 0.499F}},
                         {976052857.25, 1, {}},
                         {976052857.5, 0, {0.0F}}};

class LabelsFile : public ::testing::TestWithParam<std::string> {};

TEST_P(LabelsFile, IsReadAsItWasWrittenToTheLastPercent) {
  const TemporaryFolder folder;
  write_labels(folder.file(GetParam()), kLabels);
  const BeamLabels read = load_labels(folder.file(GetParam()));
  ASSERT_EQ(read.size(), kLabels.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].time, kLabels[i].time);
    EXPECT_EQ(read[i].laser, kLabels[i].laser);
    ASSERT_EQ(read[i].static_probability.size(), kLabels[i].static_probability.size());
    for (std::size_t n = 0; n < read[i].static_probability.size(); ++n) {
      const float was = kLabels[i].static_probability[n];
      if (std::isnan(was)) {
        EXPECT_TRUE(std::isnan(read[i].static_probability[n]));
        continue;
      }
      EXPECT_NEAR(read[i].static_probability[n], was, 0.01);
      EXPECT_EQ(is_dynamic(read[i], n), is_dynamic(kLabels[i], n)) << was;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Plain, LabelsFile, ::testing::Values("labels.txt", "labels.txt.gz"));

std::string with_header(const std::string& lines) {
  return "# MAPBED LABELS 1\n" + lines;
}

TEST(LabelsFile, WhatIsNoneIsRefusedWithTheLine) {
  EXPECT_INPUT_ERROR(parse_labels("l.txt", "1 2 3\n"), "l.txt:1: is no file of labels");
  EXPECT_INPUT_ERROR(parse_labels("l.txt", with_header("")), "l.txt: has no labels");
  EXPECT_INPUT_ERROR(parse_labels("l.txt", with_header("# a\n1.0 0\n")),
                     "l.txt:3: a line of labels begins with a time, a laser and a number of beams");
  EXPECT_INPUT_ERROR(parse_labels("l.txt", with_header("1.0 0.5 1 10\n")), "l.txt:2: a line");
  EXPECT_INPUT_ERROR(parse_labels("l.txt", with_header("1.0 0 2 10 101\n")),
                     "l.txt:2: label 2 of 2 is neither 0 to 100 nor '-'");
  EXPECT_INPUT_ERROR(parse_labels("l.txt", with_header("1.0 0 2 10\n")), "l.txt:2: ");
  EXPECT_INPUT_ERROR(parse_labels("l.txt", with_header("1.0 0 1 10 20\n")),
                     "l.txt:2: has more than the 1 labels that it says");
}

}  // namespace
}  // namespace mapbed
