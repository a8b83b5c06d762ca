// MCAP files that are damaged or cut short: an undamaged one that @mcap/core has written, in chunks
// of one or two scans.

#include "core/log/bags/mcap.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/file/text_file.h"
#include "core/testing/source_tree.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

std::string bytes_of(const std::string& name) {
  return read_text_file(source_tree() + "/core/log/bags/testdata/foreign/" + name);
}

std::string warnings_of(const RecordedLog& log) {
  std::string all;
  for (const LogWarning& warning : log.warnings) all += to_string(warning) + '\n';
  return all;
}

const std::string kFrame("laser\0", 6);  // in every scan, and in the mount

RecordedLog read(const std::string& bytes) {
  return parse_log("a.mcap", bytes);
}

// A record of its own: kind, length, content.
std::string record(char kind, const std::string& content) {
  std::string size(8, '\0');
  for (std::size_t i = 0; i < 8; ++i) size[i] = static_cast<char>(content.size() >> (8 * i));
  return kind + size + content;
}

TEST(Mcap, CutShortItHasWhatStandsBefore) {
  const std::string whole = bytes_of("unchunked.mcap");
  const RecordedLog log = read(whole.substr(0, whole.rfind(kFrame) + 20));
  EXPECT_EQ(log.measurements.size(), 5u);
  EXPECT_EQ(warnings_of(log), "a.mcap: is cut short: read up to there\n");
}

TEST(Mcap, CutShortWithinAChunkItHasWhatCanBeUnpacked) {
  for (const char* name : {"none.mcap", "lz4.mcap", "zstd.mcap"}) {
    const std::string whole = bytes_of(name);
    std::size_t readings = 0;
    for (std::size_t size = whole.size(); size > whole.size() / 2; size -= 97) {
      try {
        readings = std::max(readings, read(whole.substr(0, size)).measurements.size());
      } catch (const InputError&) {
        continue;
      }
    }
    EXPECT_EQ(readings, 6u) << name;
  }
}

TEST(Mcap, AChunkWithAWrongChecksumIsLeftOut) {
  std::string bytes = bytes_of("none.mcap");
  bytes[bytes.rfind(kFrame)] = 'L';
  const RecordedLog log = read(bytes);
  EXPECT_LT(log.measurements.size(), 6u);
  EXPECT_THAT(warnings_of(log),
              HasSubstr("a.mcap: damaged chunk, its checksum is another one: left out"));
}

TEST(Mcap, DamageBetweenChunksEndsIt) {
  const std::string whole = bytes_of("unchunked.mcap");
  const std::string start(McapReader::kMagic);
  EXPECT_INPUT_ERROR(read(start + std::string(40, '\0')),
                     "a.mcap: damaged record: left out with the rest of its file, where no laser "
                     "scan stands; fetch or copy the file again");
  EXPECT_INPUT_ERROR(read(start + record(5, "x")), "a.mcap: damaged record");
  EXPECT_INPUT_ERROR(read(start + record(6, "x")), "a.mcap: damaged chunk");
  EXPECT_INPUT_ERROR(read(start + record(15, "0000")), "a.mcap: holds no messages");
}

TEST(Mcap, APromisedLengthTakesNoMemory) {
  const std::string start(McapReader::kMagic);
  EXPECT_INPUT_ERROR(read(start + '\x06' + std::string(8, '\x7f')), "a.mcap: damaged record");
  const std::string chunk = std::string(16, '\0') + std::string(7, '\xff') + '\0' +
                            std::string(4, '\0') + std::string("\4\0\0\0zstd", 8) +
                            std::string(8, '\0');
  EXPECT_INPUT_ERROR(read(start + record(6, chunk)),
                     "a.mcap: damaged chunk: what could be unpacked");
}

TEST(Mcap, AScanWithOtherFieldsIsRefused) {
  std::string bytes = bytes_of("unchunked.mcap");
  const std::string field = "float32 angle_min";
  for (std::size_t at = 0; (at = bytes.find(field, at)) != bytes.npos; ++at)
    bytes.replace(at, field.size(), "float64 angle_min");
  EXPECT_INPUT_ERROR(read(bytes),
                     "a.mcap: '/scan' is called 'sensor_msgs/msg/LaserScan', but its messages have "
                     "other fields than those of ROS by that name");
}

TEST(Mcap, MessagesThatAreNotLittleEndianAreLeftOutWithTheReason) {
  std::string bytes = bytes_of("unchunked.mcap");
  const std::string little("\0\1\0\0\0\x10", 4);
  for (std::size_t at = 0;
       (at = bytes.find(little + std::string("\x00\x10\x5e\x5f", 4), at)) != bytes.npos;)
    bytes[at + 1] = '\0';
  EXPECT_INPUT_ERROR(read(bytes), "that is not little-endian CDR: left out");
}

}  // namespace
}  // namespace mapbed
