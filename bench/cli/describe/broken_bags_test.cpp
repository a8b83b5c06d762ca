// What `mapbed describe` and `mapbed map` say of bags that are damaged, odd, or none: what can be
// read is told; where nothing can, both end with status 1 and one line.

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/cli/testing/command_test.h"
#include "core/testing/source_tree.h"
#include "core/testing/test_bag.h"

namespace mapbed {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

namespace fs = std::filesystem;

std::string foreign(const std::string& name) {
  return read_text_file(source_tree() + "/core/log/bags/testdata/foreign/" + name);
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

class BrokenBag : public CommandTest {
 protected:
  void expect_nothing_in(const std::string& log, const std::string& message) const {
    expect_refusal({"describe", log}, log + ": " + message);
    expect_refusal({"map", log}, log + ": " + message);
  }
  // Its topics and what is wrong with it.
  void expect_topics_of(const std::string& log, const std::string& message) const {
    const Outcome outcome = call({"describe", log});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("  - /scan: "), HasSubstr(message)));
  }
  // The same, and a map.
  void expect_read(const std::string& log, const std::string& warning) const {
    expect_topics_of(log, "warning: " + warning);
    const Outcome outcome = call({"map", log, "-o", "out"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("warning: " + warning));
    fs::remove_all(path("out"));
  }
};

TEST_F(BrokenBag, OfWhichNothingCanBeReadIsRefused) {
  write("a.bag", "");
  expect_nothing_in("a.bag", "is empty");
  write("a.bag", "#ROSBAG V2.0\n");
  expect_nothing_in("a.bag", "has no index, as if it had not been closed: all of it was read");
  write("a.bag", "#ROSBAG V1.2\n" + std::string(200, ' '));
  expect_nothing_in("a.bag", "is a ROS 1 bag of another version: '#ROSBAG V1.2'");
  write("a.mcap", foreign("none.mcap").substr(0, 8));
  expect_nothing_in("a.mcap", "is cut short: read up to there");
  write("a.db3", foreign("humble.db3").substr(0, 700));
  expect_nothing_in("a.db3", "is no ROS 2 bag that can be read; SQLite says: ");
  write("a.db3.zstd", foreign("humble.db3.zstd").substr(0, 100));
  expect_nothing_in("a.db3.zstd", "");
}

TEST_F(BrokenBag, ThatIsCutShortOrWithoutAnIndexIsReadAsFarAsItGoes) {
  write("a.bag", foreign("none.bag").substr(0, 16000));
  expect_read("a.bag", "a.bag: is cut short: read up to there");
  write("a.mcap", foreign("unchunked.mcap").substr(0, 6000));
  expect_read("a.mcap", "a.mcap: is cut short: read up to there");
  TestBag scans;
  for (int k = 0; k < 4; ++k) scans.add("/scan", {.time = 1.0 + k});
  write("b.bag", TestBag::beginning() + TestBag::chunk(scans.records()));
  expect_read("b.bag", "b.bag: has no index, as if it had not been closed: all of it was read");
}

TEST_F(BrokenBag, ThatIsEncryptedIsRefusedWithTheReason) {
  const auto counted = [](const std::string& text) {
    return std::string(1, static_cast<char>(text.size())) + std::string(3, '\0') + text;
  };
  const std::string header = counted("op=\x03") + counted("encryptor=rosbag/AesCbcEncryptor");
  write("a.bag", "#ROSBAG V2.0\n" + counted(header) + counted(std::string(64, ' ')));
  expect_nothing_in("a.bag", "is encrypted by 'rosbag/AesCbcEncryptor'; decrypt it with rosbag");
}

TEST_F(BrokenBag, WhoseChunksArePackedByNothingKnownTellsWhatPackedThem) {
  write("a.bag", with(foreign("none.bag"), "compression=none", "compression=xz4?"));
  expect_topics_of("a.bag",
                   "chunk packed by 'xz4?': left out, where no laser scan stands; fetch or copy");
  expect_refusal({"map", "a.bag"}, "a.bag: chunk packed by 'xz4?': left out");
  write("a.mcap", with(foreign("zstd.mcap"), "zstd", "zpaq"));
  expect_nothing_in("a.mcap", "chunk packed by 'zpaq': left out");
}

TEST_F(BrokenBag, OfMessagesInAnotherByteOrderOrEncodingTellsIt) {
  const std::string stamp("\0\x10\x5e\x5f", 4);  // 1600000000 s begins each message
  write("a.mcap", with(foreign("unchunked.mcap"), std::string("\0\1\0\0", 4) + stamp,
                       std::string("\0\0\0\0", 4) + stamp));
  expect_topics_of("a.mcap", "that is not little-endian CDR: left out");
  expect_refusal({"map", "a.mcap"}, "that is not little-endian CDR: left out");
  write("b.mcap", with(foreign("unchunked.mcap"), std::string("\3\0\0\0cdr", 7),
                       std::string("\3\0\0\0xdr", 7)));
  expect_topics_of("b.mcap",
                   "3 sensor_msgs/LaserScan, not read: its messages are neither those of "
                   "ROS 1 nor CDR\n");
  expect_refusal({"map", "b.mcap"}, "b.mcap: holds no laser scan; its topics are ");
}

TEST_F(BrokenBag, InAFolderIsReadWithoutItsMetadataAndNamedByItsParts) {
  fs::create_directories(path("drive"));
  write("drive/drive_0.db3", foreign("humble.db3"));
  expect_topics_of("drive", "format: ROS 2 bag");
  EXPECT_EQ(call({"map", "drive", "--method", "odometry"}).status, 0);
  write("drive/metadata.yaml",
        "rosbag2_bagfile_information: {relative_file_paths: [drive_0.db3, "
        "drive_1.db3]}\n");
  expect_read("drive", "drive: 'drive_1.db3' of metadata.yaml: not there");
  write("drive/metadata.yaml", "rosbag2_bagfile_information: [\n");
  expect_read("drive", "drive: metadata.yaml cannot be read: the files are taken by their names");
  fs::remove(path("drive/metadata.yaml"));
  write("drive/other.db3", foreign("humble.db3"));
  expect_nothing_in("drive", "holds several bags: drive_0.db3, other.db3; name one of them");
  fs::remove(path("drive/other.db3"));
  write("drive/drive_0.db3", "");
  expect_refusal({"describe", "drive"}, "drive/drive_0.db3: is no bag that is known here");
  expect_refusal({"map", "drive"}, "drive/drive_0.db3: is no bag that is known here");
  expect_refusal({"map", "."}, ".: is a folder without a bag in it");
}

// A recorder that was killed leaves its last part so.
TEST_F(BrokenBag, InSeveralPartsIsReadWhereOneIsBrokenFromItsBeginningOn) {
  fs::create_directories(path("drive"));
  write("drive/drive_0.db3", foreign("humble.db3"));
  write("drive/drive_1.db3", foreign("humble.db3").substr(0, 700));
  expect_read("drive", "drive: a part of it cannot be read, drive/drive_1.db3: is no ROS 2 bag");
  write("drive/drive_0.db3", "");
  expect_nothing_in("drive", "a part of it cannot be read, drive/drive_0.db3: is no bag");
}

TEST_F(BrokenBag, TopicsThatNothingReadsAreToldAsSuch) {
  TestBag bag;
  bag.add("/scan", {.time = 1.0}).add("/scan", {.time = 2.0});
  bag.add_raw("/imu", "sensor_msgs/Imu", "6a62c6daae103f4ff57a132d6f95cec2", 1.0, "x");
  write("a.bag", bag.bytes());
  expect_topics_of("a.bag",
                   "  - /imu: 1 sensor_msgs/Imu, not read: no measurement here is of this kind\n"
                   "  - /scan: 2 sensor_msgs/LaserScan\n"
                   "measurements: 2 scans and 0 odometry readings in 1.0 s\n");
}

}  // namespace
}  // namespace mapbed
