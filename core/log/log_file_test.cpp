#include "core/log/log_file.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/file/text_file.h"
#include "core/geometry/angle.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string flaser(int beams, double range, double time) {
  std::string line = fmt::format("FLASER {}", beams);
  for (int i = 0; i < beams; ++i) line += fmt::format(" {}", range);
  return line + fmt::format(" 0 0 0 0 0 0 {} host 0\n", time);
}

std::string good_lines(int count, double first_time = 10.0) {
  std::string text;
  for (int i = 0; i < count; ++i) text += flaser(181, 3.25, first_time + i);
  return text;
}

std::vector<LaserScan> scans_of(const RecordedLog& log) {
  std::vector<LaserScan> scans;
  for (const Measurement& m : log.measurements)
    if (const auto* scan = std::get_if<LaserScan>(&m)) scans.push_back(*scan);
  return scans;
}

std::string message_of(const std::string& text, const LogOptions& options = {}) {
  try {
    parse_log("a.log", text, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string warnings_of(const RecordedLog& log) {
  std::string all;
  for (const LogWarning& warning : log.warnings) all += to_string(warning) + '\n';
  return all;
}

std::string warnings_of(const std::string& text) {
  return warnings_of(parse_log("a.log", text));
}

// Order and faults.

TEST(BadLog, ATruncatedLineIsLeftOutAndNamed) {
  std::string text = good_lines(12);
  text.resize(text.size() - 200);
  const RecordedLog log = parse_log("a.log", text);
  EXPECT_EQ(scans_of(log).size(), 11u);
  EXPECT_EQ(warnings_of(log), "a.log:12: truncated or garbled FLASER line: left out\n");
}

TEST(BadLog, OneOfManyBrokenLinesInTheMiddleIsLeftOut) {
  EXPECT_EQ(warnings_of(good_lines(12) + "FLASER 3 1 x 3 0 0 0 0 0 0 22 h 0\n" + good_lines(9, 30)),
            "a.log:13: truncated or garbled FLASER line: left out, 'x' is no number\n");
  EXPECT_EQ(warnings_of(good_lines(12) + "ODOM 1 2\n" + good_lines(9, 30)),
            "a.log:13: truncated or garbled ODOM line: left out\n");
  EXPECT_EQ(warnings_of(good_lines(12) + "\x01\x02 1 2\n" + good_lines(9, 30)),
            "a.log:13: line that is not a CARMEN message: left out\n");
}

TEST(BadLog, ALogOfManyBrokenLinesIsRefused) {
  EXPECT_EQ(message_of(good_lines(3) + "FLASER 9 1\nFLASER 9 1\n"),
            "a.log:4: truncated or garbled FLASER line: left out (2 of 8 messages are broken); the "
            "file is damaged or not of this format; fetch it again");
}

TEST(BadLog, ADecimalCommaIsNamedWithItsField) {
  std::string text;
  for (int i = 0; i < 4; ++i) text += "FLASER 3 2.5 2,4 2.5 0 0 0 0 0 0 17 h 17\n";
  EXPECT_EQ(
      message_of(text),
      "a.log:1: truncated or garbled FLASER line: left out, '2,4' has a decimal comma (4 of 4 "
      "messages are broken); write decimals with a point");
}

TEST(BadLog, StampsInAnotherUnitAreNamedByIt) {
  const auto message = [](const std::string& stamp) {
    return message_of(stamp + " 2 3 3\n" + stamp + " 2 3 3\n");
  };
  EXPECT_EQ(message("1600000000000000000"),
            "a.log:1: time stamp that is not a time: line left out, 1600000000000000000 looks like "
            "nanoseconds (2 of 2 messages are broken); write stamps in seconds");
  EXPECT_THAT(message("1600000000000000"), HasSubstr("looks like microseconds"));
  EXPECT_THAT(message("1600000000000"), HasSubstr("looks like milliseconds"));
}

TEST(BadLog, ScansOfSeveralUnknownCountsAreToldWithTheirCounts) {
  const std::string text = "1 2 3 3\n2 3 3 3 3\n3 4 3 3 3 3\n4 2 3 3\n5 3 3 3 3\n6 4 3 3 3 3\n";
  EXPECT_EQ(message_of(text),
            "a.log:1: holds 6 scans of 2, 3, 4 beams, whose fields of view are not known; set "
            "field_of_view, or bearing_step");
}

TEST(Log, TakesInfinityAsYamlAndAsPeopleWriteIt) {
  const RecordedLog log = parse_log(
      "a.log", "# angle_min -1 angle_increment 0.5 range_max 12\n1 5 2 .inf +inf -.inf +3.5\n");
  EXPECT_EQ(scans_of(log)[0].ranges, (std::vector<double>{2, 12, 12, 0, 3.5}));
}

TEST(Log, AnOptionReplacesItsOwnQuantityOfAScanThatStatesItsGeometry) {
  const std::string line =
      "ROBOTLASER1 0 -3 5 0.5 12 0.01 0 3 1 2 3 0 0 0 0 0 0 0 0 0 0 0 0 17 h 17\n";
  const auto scan = [&line](const LogOptions& options) {
    return scans_of(parse_log("a.log", line, options))[0];
  };
  const auto geometry = [](const LaserScan& s) {
    return std::pair(s.first_bearing, s.bearing_step);
  };
  EXPECT_EQ(geometry(scan({.first_bearing = {-3.0}})), geometry(scan({})));
  EXPECT_EQ(geometry(scan({.first_bearing = {0.0}})), std::pair(0.0, 0.5));
  EXPECT_EQ(geometry(scan({.bearing_step = 0.25})), std::pair(-3.0, 0.25));
  EXPECT_EQ(geometry(scan({.field_of_view = 2.0})), std::pair(-1.0, 1.0));
}

TEST(BadLog, WhatTakesMoreMemoryThanTextIsRefusedByItsMemory) {
  std::string text = good_lines(1);
  for (int i = 0; i < 1000; ++i) text += "ODOM 0 0 0 0 0 0 1" + std::to_string(1000 + i) + "\n";
  const double enough = 1000.0 * 2 * sizeof(Measurement) + 1e5;
  EXPECT_EQ(parse_log("a.log", text, {.max_text = enough}).measurements.size(), 1002u);
  EXPECT_THROW(parse_log("a.log", text, {.max_text = static_cast<double>(text.size())}),
               InputError);
  std::string parameters;
  for (int i = 0; i < 1000; ++i) parameters += "PARAM " + std::to_string(i) + " 0\n";
  EXPECT_THROW(parse_log("a.log", parameters + good_lines(1), {.max_text = 5e4}), InputError);
}

TEST(BadLog, AnEmptyLogIsRefused) {
  EXPECT_EQ(message_of(""), "a.log: is empty; a log has lines such as FLASER or ROBOTLASER1");
  EXPECT_EQ(message_of("# only\n\n"),
            "a.log: is empty; a log has lines such as FLASER or ROBOTLASER1");
}

TEST(BadLog, ALogWithoutScansIsRefused) {
  EXPECT_EQ(message_of("ODOM 1 2 3 0 0 0 10 host 0\n"),
            "a.log: holds no laser scan; a map needs lines such as FLASER or ROBOTLASER1");
}

TEST(BadLog, AbsurdRangesAreIgnoredBeamByBeam) {
  const std::string line = "FLASER 6 -1 nan 1e9 2 inf 0 0 0 0 0 0 0 10 host 0\n";
  const RecordedLog log = parse_log("a.log", line, {.field_of_view = kPi});
  EXPECT_EQ(scans_of(log)[0].ranges, (std::vector<double>{0, 0, 0, 2, 8, 0}));
  EXPECT_EQ(
      warnings_of(log),
      "a.log:1: absurd range (negative, not a number or above 1 km): beam ignored (3 times)\n");
}

TEST(BadLog, RepeatedStampsAreNamed) {
  EXPECT_EQ(warnings_of(good_lines(2) + flaser(181, 3, 11.0)),
            "a.log:3: same time stamp as the scan before\n");
}

TEST(BadLog, StampsThatAreLittleTooOldArePutInOrder) {
  const RecordedLog log = parse_log("a.log", good_lines(3) + flaser(181, 1.5, 11.5));
  EXPECT_EQ(scans_of(log)[2].ranges[0], 1.5);
  EXPECT_EQ(warnings_of(log),
            "a.log:4: time stamp older than one before it: put in order (2 times)\n");
}

TEST(BadLog, OneStampFarTooOldIsADamagedOne) {
  const RecordedLog log =
      parse_log("a.log", good_lines(3) + flaser(181, 1.5, 3.0) + good_lines(3, 20));
  EXPECT_EQ(scans_of(log).size(), 6u);
  EXPECT_EQ(warnings_of(log),
            "a.log:4: time stamp far older than those around it: message left out\n");
}

TEST(BadLog, AClockThatWasSetBackIsRefused) {
  EXPECT_EQ(message_of(good_lines(3, 100) + good_lines(2, 50)),
            "a.log:4: the time goes back by 51.000 s, from 102.000000 to 51.000000; cut the log "
            "there, use the other stamp (stamp) or raise reorder_within");
}

TEST(BadLog, AStampThatIsNoTimeIsLeftOut) {
  EXPECT_THAT(warnings_of(good_lines(20) + flaser(181, 3, NAN)),
              StartsWith("a.log:21: time stamp that is not a time: line left out"));
}

TEST(BadLog, LostStampsAreMadeUp) {
  std::string text;
  for (int i = 0; i < 3; ++i) text += flaser(181, 3.0, 1.04e9);
  const RecordedLog log = parse_log("a.log", text);
  EXPECT_FALSE(log.has_stamps);
  EXPECT_NEAR(scans_of(log)[2].time, 0.2, 1e-12);
  EXPECT_THAT(warnings_of(log),
              HasSubstr("all scans have the same time stamp: taken as 0.1 s apart"));
}

TEST(BadLog, AChangingNumberOfBeamsIsNamed) {
  const RecordedLog log = parse_log("a.log", good_lines(3) + flaser(361, 3.0, 20));
  EXPECT_EQ(scans_of(log)[3].bearing_step, radians(0.5));
  EXPECT_EQ(warnings_of(log), "a.log:4: number of beams differs from the scan before\n");
}

TEST(BadLog, AFewScansOfAnUnknownLaserAreLeftOut) {
  const RecordedLog log = parse_log("a.log", good_lines(3) + flaser(97, 3.0, 20));
  EXPECT_EQ(scans_of(log).size(), 3u);
  EXPECT_THAT(warnings_of(log),
              HasSubstr("a.log:4: the field of view of 97 beams is not known: scan left out"));
}

TEST(BadLog, AnUnknownLaserNeedsItsFieldOfView) {
  const std::string text = flaser(97, 3.0, 20);
  EXPECT_EQ(message_of(text),
            "a.log:1: the field of view of 97 beams is not known; set field_of_view, or "
            "bearing_step");
  const auto scans = scans_of(parse_log("a.log", text, {.field_of_view = radians(96)}));
  EXPECT_NEAR(scans[0].first_bearing, radians(-48), 1e-12);
  EXPECT_NEAR(scans[0].bearing_step, radians(1), 1e-12);
}

TEST(BadLog, BagsWithNothingInThemAreRefused) {
  EXPECT_EQ(message_of("#ROSBAG V2.0\n\x01"),
            "a.log: is cut short: read up to there, where no laser scan stands; fetch or copy the "
            "file again");
  EXPECT_THAT(message_of(std::string("SQLite format 3\0abc", 19)),
              HasSubstr("a.log: is no ROS 2 bag that can be read; SQLite says: "));
  EXPECT_EQ(message_of("\x89MCAP0\r\n"),
            "a.log: is cut short: read up to there, where no laser scan stands; fetch or copy the "
            "file again");
}

TEST(BadLog, WhatIsNoLogIsRefused) {
  EXPECT_EQ(message_of(std::string("FLASER\0", 7)),
            "a.log: is neither text nor a bag of ROS that is known here; logs are read as plain "
            "text, gzipped text, bags of ROS 1 and 2 and MCAP");
  EXPECT_EQ(
      message_of("{\"a\": 1}\n"),
      "a.log: is in no log format that is known here; known are DP-SLAM, CARMEN, `t n ranges` "
      "lines, CoreSLAM, bags of ROS 1, bags of ROS 2, MCAP");
  EXPECT_THAT(message_of("# Title\n\nA text, as it is.\nWith two sentences.\n"),
              HasSubstr("a.log: is in no log format that is known here; known are DP-SLAM"));
  EXPECT_THAT(message_of("1 2 3\n"), HasSubstr("is in no log format that is known here"));
}

TEST(BadLog, OptionsThatMakeNoSenseAreRefused) {
  EXPECT_EQ(message_of(good_lines(1), {.first_bearing = {1, 2}}),
            "log option first_bearing takes one number or none");
  EXPECT_EQ(message_of(good_lines(1), {.robot_from_laser = {1}}),
            "log option robot_from_laser takes three numbers, x, y, theta, or none");
  EXPECT_EQ(message_of(good_lines(1), {.scan_period = 0.0}),
            "log option scan_period must be positive");
}

// Files.

class LogFile : public ::testing::Test {
 protected:
  std::string written(const std::string& name, const std::string& text) const {
    const std::string path = ::testing::TempDir() + "log_file_" + name;
    write_text_file(path, text);
    return path;
  }
  static std::string message_of(const std::string& path, const LogOptions& options = {}) {
    try {
      load_log(path, options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
};

TEST_F(LogFile, PlainAndPackedReadAlikeAcrossBlocks) {
  const std::string text = good_lines(3000);  // more than two blocks of 1 MiB
  ASSERT_GT(text.size(), 2'200'000u);
  const RecordedLog plain = load_log(written("plain.log", text));
  const RecordedLog packed = load_log(written("packed.log.gz", text));
  EXPECT_EQ(scans_of(plain).size(), 3000u);
  EXPECT_EQ(scans_of(packed).size(), 3000u);
  EXPECT_EQ(scans_of(plain).back().time, 3009.0);
  EXPECT_TRUE(plain.warnings.empty());
}

TEST_F(LogFile, TheDialectIsToldBehindAnyNumberOfComments) {
  std::string comments;
  while (comments.size() < 1'200'000) comments += "# a line that says nothing\n";  // over one piece
  const RecordedLog log = load_log(written("talkative.log", comments + good_lines(3)));
  EXPECT_EQ(scans_of(log).size(), 3u);
  EXPECT_TRUE(log.warnings.empty());
}

TEST_F(LogFile, AMissingFileOrAFolderIsRefused) {
  EXPECT_EQ(message_of("nowhere.log"), "nowhere.log: no such file");
  EXPECT_THAT(message_of(::testing::TempDir()), HasSubstr("is a folder without a bag in it"));
}

TEST_F(LogFile, TheFolderOfARos2BagIsReadAsABag) {
  const std::filesystem::path bag = std::filesystem::path(::testing::TempDir()) / "drive_bag";
  std::filesystem::create_directories(bag);
  std::ofstream(bag / "drive_0.db3") << "SQLite format 3";
  EXPECT_THAT(message_of(bag.string()),
              HasSubstr("drive_bag/drive_0.db3: is no ROS 2 bag that can be read"));
  std::filesystem::remove_all(bag);
}

TEST_F(LogFile, AByteOrderMarkIsReadPast) {
  const RecordedLog log = load_log(written("marked.log", "\xef\xbb\xbf" + good_lines(3)));
  EXPECT_EQ(scans_of(log).size(), 3u);
  EXPECT_TRUE(log.warnings.empty());
}

TEST_F(LogFile, GzipThatIsCutShortIsRefused) {
  std::string packed;
  {
    std::ifstream in(written("whole.log.gz", good_lines(300)), std::ios::binary);
    packed.assign(std::istreambuf_iterator<char>(in), {});
  }
  const std::string path = written("cut.log", packed.substr(0, packed.size() / 2));
  EXPECT_THAT(message_of(path),
              HasSubstr("the gzip data are cut short; fetch or copy the file again"));
}

TEST_F(LogFile, GzipThatUnpacksToTooMuchIsRefused) {
  const std::string path = written("bomb.log.gz", good_lines(300));
  EXPECT_THAT(message_of(path, {.max_text = 1e5}),
              HasSubstr("unpacks to more than 0.1 MB; set max_text if the file is to be trusted"));
}

TEST_F(LogFile, AnEndlessLineIsRefused) {
  const std::string endless(20u << 20, '1');
  EXPECT_THAT(message_of(written("line.log.gz", good_lines(2) + endless)),
              HasSubstr("has a line of more than 16 MiB; is this a file of lines?"));
  EXPECT_THAT(message_of(written("only.log.gz", endless)), HasSubstr("is in no log format"));
}

// As drivers that write 0 where nothing came back.
std::string half_zeros(double highest) {
  return "# angle_min -1.5 angle_max 1.5 angle_increment 1 range_max 11\n"
         "1 4 0 2 0 3\n2 4 0 2 0 3\n3 4 0 2 1 " +
         std::to_string(highest) + "\n";
}

TEST(ZeroReading, IsAFailedOneUnlessItIsSaidToBeNoReturn) {
  EXPECT_EQ(scans_of(parse_log("a.scans", half_zeros(3.0)))[0].ranges,
            (std::vector{0.0, 2.0, 0.0, 3.0}));
  const RecordedLog log = parse_log("a.scans", half_zeros(3.0), {.zero = ZeroReading::no_return});
  EXPECT_EQ(scans_of(log)[0].ranges, (std::vector{11.0, 2.0, 11.0, 3.0}));
  EXPECT_TRUE(log.warnings.empty());
}

TEST(ZeroReading, IsToldWhereThereAreManyAndNoneIsTheMaximumRange) {
  const std::vector<LogWarning> told = parse_log("a.scans", half_zeros(3.0)).warnings;
  ASSERT_EQ(told.size(), 1U);
  EXPECT_THAT(to_string(told[0]),
              HasSubstr("front laser: 42 % of its readings are 0, and none is its "
                        "maximum range: they count as failed; zero: no_return, if"));
  EXPECT_TRUE(parse_log("a.scans", half_zeros(11.0)).warnings.empty());
}

}  // namespace
}  // namespace mapbed
