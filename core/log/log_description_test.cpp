#include "core/log/log_description.h"

#include <cstdlib>
#include <filesystem>
#include <ostream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/file/hash.h"
#include "core/file/text_file.h"
#include "core/geometry/angle.h"
#include "core/testing/source_tree.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

const std::string kLogs = source_tree() + "/scenarios/logs/";

class Description : public ::testing::Test {
 protected:
  // A description, and its log in a folder of their own.
  std::string written(const std::string& log, const std::string& checksum,
                      const std::string& more = "") const {
    if (!log.empty()) write_text_file(folder_.file("a.log"), log);
    write_text_file(folder_.file("a.yaml"),
                    fmt::format("about: a\nfile: a.log\nsha256: {}\nsource: s\nlicence: l\nfetch: "
                                "from the shelf\nrobot: r\nlaser: x\n{}",
                                checksum, more));
    return folder_.file("a.yaml");
  }
  static std::string message_of(const std::string& path) {
    try {
      open_log(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  TemporaryFolder folder_;  // tests run side by side
  const std::string log_ = "FLASER 3 1 2 3 0 0 0 0 0 0 5 h 0\n";
  const std::string options_ = "log: {field_of_view: 90 deg, robot_from_laser: [0.5, 0, 0]}\n";
};

TEST_F(Description, OpensItsLogWithItsOptionsAndThoseThatOverrideThem) {
  const std::string path = written(log_, sha256(log_), options_);
  const RecordedLog log = open_log(path);
  const auto& scan = std::get<LaserScan>(log.measurements.at(1));
  EXPECT_NEAR(scan.first_bearing, -kPi / 4, 1e-12);
  EXPECT_EQ(scan.robot_from_laser.planar.x, 0.5);
  const RecordedLog other = open_log(path, {parse_setting("max_range=4 m")});
  EXPECT_EQ(std::get<LaserScan>(other.measurements.at(1)).max_range, 4.0);
}

TEST_F(Description, SaysHowToGetALogThatIsNotThere) {
  const std::string path = written("", sha256(log_));
  EXPECT_EQ(message_of(path), path +
                                  ": its log 'a.log' is not here; get it (from the shelf) and set "
                                  "MAPBED_DATA to the folder that holds 'a.log'");
}

TEST_F(Description, RefusesALogOfAnotherChecksum) {
  EXPECT_THAT(
      message_of(written(log_, sha256("other"), options_)),
      HasSubstr(fmt::format("a.log: is not the file that a.yaml describes: its SHA-256 is "
                            "{}…, not {}…; fetch it again (from the shelf), or map it by its "
                            "own path",
                            sha256(log_).substr(0, 12), sha256("other").substr(0, 12))));
}

TEST_F(Description, RefusesWrongFields) {
  EXPECT_THAT(message_of(written(log_, "123")),
              HasSubstr("a.yaml:3: a SHA-256 has 64 hexadecimal"));
  EXPECT_THAT(message_of(written(log_, sha256(log_), "lazer: y\n")),
              HasSubstr("a.yaml:9: unknown key 'lazer'"));
  EXPECT_THAT(message_of(written(log_, sha256(log_), "log: {max_rang: 3 m}\n")),
              HasSubstr("unknown key 'max_rang'"));
}

TEST_F(Description, NamesTheRelationsThatWereMeasuredAlongTheLog) {
  write_text_file(folder_.file("a.relations"), "0 1 0.5 0 0 0 0 0\n");
  const std::string relations =
      fmt::format("relations: {{file: a.relations, sha256: {}}}\n", sha256("0 1 0.5 0 0 0 0 0\n"));
  const LogDescription description = load_log_description(written(log_, sha256(log_), relations));
  HashedFiles files;
  EXPECT_EQ(find_stored(description, description.relations, files).path,
            folder_.file("a.relations"));
  EXPECT_TRUE(description.relations_odometry.file.empty());
  EXPECT_TRUE(is_here(description));
  std::filesystem::remove(folder_.file("a.relations"));
  EXPECT_FALSE(is_here(description));
  EXPECT_INPUT_ERROR(find_stored(description, description.relations, files),
                     "its file 'a.relations' is not here");
}

TEST_F(Description, NamesAPathOfAnotherProgram) {
  const std::string poses = "0 1 0.5 0\n";
  write_text_file(folder_.file("a.poses"), poses);
  const std::string reference =
      fmt::format("reference: {{file: a.poses, sha256: {}}}\n", sha256(poses));
  const LogDescription description = load_log_description(written(log_, sha256(log_), reference));
  HashedFiles files;
  EXPECT_EQ(find_stored(description, description.reference, files).path, folder_.file("a.poses"));
  EXPECT_TRUE(is_here(description));
  std::filesystem::remove(folder_.file("a.poses"));
  EXPECT_FALSE(is_here(description));
}

TEST_F(Description, GivesOnlyTheBeginningOfALogWhereThatIsAsked) {
  const std::string three =
      "FLASER 3 1 2 3 0 0 0 0 0 0 5 h 0\nFLASER 3 1 2 3 0 0 0 0 0 0 6 h 0\n"
      "FLASER 3 1 2 3 0 0 0 0 0 0 7.5 h 0\n";
  const std::string path = written(three, sha256(three), options_);
  EXPECT_EQ(open_log(path).measurements.size(), 6u);  // odometry and scan of each line
  EXPECT_EQ(open_log(path, {parse_setting("longest=2 s")}).measurements.size(), 4u);
}

TEST_F(Description, TheExampleOpensWithoutAnyData) {
  EXPECT_EQ(open_log(kLogs + "example.yaml").format, "CARMEN");
}

struct Sample {
  const char* name;
  const char* format;
  std::size_t scans;
  std::size_t beams;
  double first_bearing;  // [deg]
  double bearing_step;   // [deg]
  double max_range;      // [m]
  double laser_ahead;    // [m]
  bool has_odometry;
};

void PrintTo(const Sample& sample, std::ostream* out) {
  *out << sample.name;
}

// Scans and beams as the logs' own notes count them.
const Sample kSamples[] = {
    {"intel", "CARMEN", 4682, 180, -90, 1, 81.83, 0, true},
    {"intel_910", "CARMEN", 910, 180, -90, 1, 81.83, 0, true},
    {"fr079", "CARMEN", 4791, 360, -90, 0.5, 81.83, -0.04, true},
    {"aces", "CARMEN", 440, 180, -90, 1, 50, 0, true},
    {"seattle", "CARMEN", 241, 361, -90, 0.5, 81.83, 0, true},
    {"freiburg_101", "CARMEN", 292, 360, -90, 0.5, 81.83, -0.04, true},
    {"freiburg_campus", "CARMEN", 2008, 360, -90, 0.5, 81.83, 0, true},
    {"tinyslam_exp1", "CoreSLAM", 756, 682, -119.53125, 360.0 / 1024, 5.6, 0.145, true},
    {"tinyslam_exp2", "CoreSLAM", 641, 682, -119.53125, 360.0 / 1024, 5.6, 0.145, true},
    {"tinyslam_test_lab", "CoreSLAM", 590, 682, -119.53125, 360.0 / 1024, 5.6, 0.145, true},
    {"scan_tools_demo", "scan list", 278, 681, -119.5313, 0.3515625, 5.6, 0, false},
    {"dpslam_loop5", "DP-SLAM", 551, 181, -90, 1, 8.183, 0.4, true},
    {"sena_malaga", "CARMEN", 225, 361, -90, 0.5, 81.83, 0.78, true}};

class SampleLog : public ::testing::TestWithParam<Sample> {};

TEST_P(SampleLog, ReadsAsItsNotesSay) {
  const char* const data = std::getenv("MAPBED_DATA");
  if (data == nullptr || *data == '\0') GTEST_SKIP() << "MAPBED_DATA is not set";
  const Sample& sample = GetParam();
  const RecordedLog log = open_log(kLogs + sample.name + ".yaml");
  EXPECT_EQ(log.format, sample.format);
  std::size_t scans = 0;
  std::size_t odometry = 0;
  for (const Measurement& m : log.measurements) {
    const auto* scan = std::get_if<LaserScan>(&m);
    if (scan == nullptr) {
      ++odometry;
      continue;
    }
    ++scans;
    ASSERT_EQ(scan->ranges.size(), sample.beams);
    ASSERT_NEAR(degrees(scan->first_bearing), sample.first_bearing, 1e-3);
    ASSERT_NEAR(degrees(scan->bearing_step), sample.bearing_step, 1e-5);
    ASSERT_EQ(scan->max_range, sample.max_range);
    ASSERT_EQ(scan->robot_from_laser.planar, (Pose2{sample.laser_ahead, 0, 0}));
  }
  EXPECT_EQ(scans, sample.scans);
  EXPECT_EQ(odometry, sample.has_odometry ? scans : 0);
}

INSTANTIATE_TEST_SUITE_P(All, SampleLog, ::testing::ValuesIn(kSamples),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace mapbed
