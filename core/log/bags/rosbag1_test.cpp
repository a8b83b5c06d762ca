// Bags of ROS 1 that are damaged, cut short, or were never closed.

#include "core/log/bags/rosbag1.h"

#include <cstdint>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/testing/test_bag.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

TestBag four_scans(double start = 1.0) {
  TestBag bag;
  for (int k = 0; k < 4; ++k) bag.add("/scan", {.time = start + k});
  return bag;
}

std::string warnings_of(const RecordedLog& log) {
  std::string all;
  for (const LogWarning& warning : log.warnings) all += to_string(warning) + '\n';
  return all;
}

RecordedLog read(const std::string& bytes) {
  return parse_log("a.bag", bytes);
}

TEST(Rosbag1, AWholeOneIsReadWithoutARemark) {
  EXPECT_THAT(read(four_scans().bytes()).warnings, IsEmpty());
}

TEST(Rosbag1, WithoutAnIndexItHasAllThatIsInIt) {
  const RecordedLog log = read(TestBag::beginning() + TestBag::chunk(four_scans().records()));
  EXPECT_EQ(log.measurements.size(), 4u);
  EXPECT_EQ(warnings_of(log),
            "a.bag: has no index, as if it had not been closed: all of it was read\n");
  // A recorder that was killed: the length of its last chunk is still 0.
  const RecordedLog killed =
      read(TestBag::beginning() + TestBag::chunk("") + four_scans().records());
  EXPECT_EQ(killed.measurements.size(), 4u);
}

TEST(Rosbag1, CutShortItHasWhatStandsBefore) {
  const std::string bytes = TestBag::beginning() + TestBag::chunk(four_scans().records());
  const RecordedLog log = read(bytes.substr(0, bytes.size() - 10));
  EXPECT_EQ(log.measurements.size(), 3u);
  EXPECT_EQ(warnings_of(log), "a.bag: is cut short: read up to there\n");
}

TEST(Rosbag1, ADamagedChunkDoesNotHideTheNextOne) {
  const std::string records = four_scans().records();
  std::string damaged = records;
  damaged.replace(records.size() / 2, 40, 40, '\xff');
  const RecordedLog log =
      read(TestBag::beginning() + TestBag::chunk(damaged) +
           TestBag::chunk(four_scans(10.0).records(), "bz2") +  // these bytes are no bzip2
           TestBag::chunk(four_scans(20.0).records()));
  EXPECT_GT(log.measurements.size(), 4u);
  EXPECT_EQ(time_of(log.measurements.back()), 23.0);
  EXPECT_THAT(warnings_of(log), HasSubstr("a.bag: damaged "));
}

// As laser_scan_matcher's demo bag of 2010: 5560 for 278 entries of 12 bytes.
TEST(Rosbag1, AnIndexThatTellsAWrongLengthDoesNotHideTheNextChunk) {
  const RecordedLog log =
      read(TestBag::beginning() + TestBag::chunk(four_scans().records()) + TestBag::index(4, 80) +
           TestBag::chunk(four_scans(10.0).records()) + TestBag::index(4, 80));
  EXPECT_EQ(log.measurements.size(), 8u);
  EXPECT_THAT(log.warnings, IsEmpty());
}

TEST(Rosbag1, OthersAreRefusedWithTheReason) {
  EXPECT_INPUT_ERROR(
      read("#ROSBAG V1.2\n" + std::string(200, '\0')),
      "a.bag: is a ROS 1 bag of another version: '#ROSBAG V1.2'; bags of version 2.0 "
      "are read; `rosbag fix` makes one of it");
  EXPECT_INPUT_ERROR(read("#ROSBAG V2.0\n"), "a.bag: has no index, as if it had not been closed");
  EXPECT_INPUT_ERROR(read(TestBag::beginning() + std::string(100, '\xff')),
                     "a.bag: is cut short: read up to there, where no laser scan stands; fetch or "
                     "copy the file again");
}

// With its length in front.
std::string counted(const std::string& text) {
  return std::string(1, static_cast<char>(text.size())) + std::string(3, '\0') + text;
}

TEST(Rosbag1, AnEncryptedOneIsRefusedWithTheName) {
  const std::string header = counted("op=\x03") + counted("encryptor=rosbag/AesCbcEncryptor");
  EXPECT_INPUT_ERROR(read("#ROSBAG V2.0\n" + counted(header) + counted("")),
                     "a.bag: is encrypted by 'rosbag/AesCbcEncryptor'; decrypt it with rosbag");
}

TEST(Rosbag1, EndlessConnectionsAreDamage) {
  std::string bytes = TestBag::beginning();
  for (std::uint32_t k = 0; k <= 1u << 16; ++k) {
    const char number[] = {static_cast<char>(k), static_cast<char>(k >> 8),
                           static_cast<char>(k >> 16), '\0'};
    const std::string header = counted("op=\x07") + counted("conn=" + std::string(number, 4));
    bytes += counted(header) + counted("");
  }
  EXPECT_INPUT_ERROR(read(bytes), "a.bag: damaged record: left out with the rest of its file");
}

TEST(Rosbag1, APromisedLengthTakesNoMemory) {
  const std::string packed = "BZh9";  // the beginning of bzip2, and no more
  EXPECT_INPUT_ERROR(read(TestBag::beginning() + TestBag::chunk(packed, "bz2", 0xffffffffu)),
                     "a.bag: damaged chunk");
  EXPECT_INPUT_ERROR(read(TestBag::beginning() + TestBag::chunk("??????", "xz")),
                     "a.bag: chunk packed by 'xz': left out");
}

TEST(Rosbag1, WhereItIsCutIntoPiecesDoesNotMatter) {
  const std::string bytes = four_scans().bytes();
  for (const std::size_t size : {1u, 7u, 64u}) {
    BagLog log("a.bag", {});
    Rosbag1Reader reader(log);
    for (std::size_t at = 0; at < bytes.size(); at += size) reader.add(bytes.substr(at, size));
    reader.finish();
    EXPECT_EQ(log.finish("ROS 1 bag").measurements.size(), 4u) << size;
  }
}

}  // namespace
}  // namespace mapbed
