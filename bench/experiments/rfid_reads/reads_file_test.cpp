#include "bench/experiments/rfid_reads/reads_file.h"

#include <gmock/gmock.h>

#include "core/geometry/angle.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;

const std::string kHead = "tag_x,tag_y,tag_z,t_ms,antenna,freq_MHz,epc,rssi,phase\n";

TEST(ReadsFile, TellsWhereWhichTagWasReadAndHow) {
  const PlacedReads reads =
      parse_reads("reads.csv", kHead +
                                   "1,0,0.5,17,ANT3,866.9,B,-70.5;-81,90;-45\n"
                                   "-1,2,0.5,18,ANT1,None,A,-60;-61,0;180\r\n"
                                   "1,0,0.5,19,ANT3,866.9,A,-71;-80,10;20\n");
  EXPECT_THAT(reads.tags, ElementsAre("A", "B"));
  EXPECT_THAT(reads.places,
              ElementsAre(Eigen::Vector3d(-1.0, 2.0, 0.5), Eigen::Vector3d(1.0, 0.0, 0.5)));
  EXPECT_EQ(reads.antennas, 3);
  ASSERT_EQ(reads.reads.size(), 3U);
  const PlacedRead& first = reads.reads[0];
  EXPECT_EQ(first.place, 1);
  EXPECT_EQ(first.antenna, 2);
  EXPECT_EQ(first.tag, 1);
  EXPECT_EQ(first.frequency, 866.9e6);
  EXPECT_EQ(first.strength[0], -70.5);
  EXPECT_EQ(first.strength[1], -81.0);
  EXPECT_NEAR(first.phase[0], 0.5 * kPi, 1e-12);
  EXPECT_NEAR(first.phase[1], -0.25 * kPi, 1e-12);
  EXPECT_FALSE(reads.reads[1].frequency);
  EXPECT_EQ(reads.reads[2].place, 1);
}

TEST(ReadsFile, RefusesBrokenRowsWithTheirLines) {
  const std::string good = "1,0,0.5,17,ANT3,866.9,B,-70.5;-81,90;-45\n";
  const auto parsed = [&](const std::string& row) {
    return parse_reads("reads.csv", kHead + good + row + "\n" + good);
  };
  EXPECT_INPUT_ERROR(parsed("1,0,0.5,17,ANT3,866.9,B,-70.5;-81"),
                     "reads.csv:3: there are 8 fields, not nine");
  EXPECT_INPUT_ERROR(parsed("1,zero,0.5,17,ANT3,866.9,B,-70.5;-81,90;-45"),
                     "reads.csv:3: tag_y is 'zero', no number");
  EXPECT_INPUT_ERROR(parsed("1,0,nan,17,ANT3,866.9,B,-70.5;-81,90;-45"), "reads.csv:3: tag_z");
  EXPECT_INPUT_ERROR(parsed("1,0,0.5,17,PORT3,866.9,B,-70.5;-81,90;-45"),
                     "reads.csv:3: the antenna is 'PORT3'");
  EXPECT_INPUT_ERROR(parsed("1,0,0.5,17,ANT0,866.9,B,-70.5;-81,90;-45"),
                     "reads.csv:3: the antenna is 'ANT0'");
  EXPECT_INPUT_ERROR(parsed("1,0,0.5,17,ANT3,866900,B,-70.5;-81,90;-45"),
                     "reads.csv:3: the frequency is '866900' MHz");
  EXPECT_INPUT_ERROR(parsed("1,0,0.5,17,ANT3,866.9,,-70.5;-81,90;-45"),
                     "reads.csv:3: the tag has no name");
  EXPECT_INPUT_ERROR(parsed("1,0,0.5,17,ANT3,866.9,B,-70.5,90;-45"),
                     "reads.csv:3: the RSSI is '-70.5', not one number for each of two ports");
  EXPECT_INPUT_ERROR(parsed("1,0,0.5,17,ANT3,866.9,B,-70.5;-81,90;?"),
                     "reads.csv:3: the phase is '?', no number");
  EXPECT_INPUT_ERROR(parse_reads("reads.csv", kHead), "reads.csv: there are no reads");
}

}  // namespace
}  // namespace mapbed
