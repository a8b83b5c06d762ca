// ROS 2 bags in SQLite that are damaged, or are no bags.

#include "core/log/bags/rosbag2.h"

#include <filesystem>
#include <fstream>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "core/file/text_file.h"
#include "core/testing/source_tree.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::string foreign(const std::string& name) {
  return source_tree() + "/core/log/bags/testdata/foreign/" + name;
}

class Rosbag2 : public ::testing::Test {
 protected:
  std::string database(const std::string& statements) const {
    const std::string path = folder_.file("a.db3");
    fs::remove(path);
    sqlite3* made = nullptr;
    sqlite3_open(path.c_str(), &made);
    const std::unique_ptr<sqlite3, int (*)(sqlite3*)> closed(made, sqlite3_close);
    EXPECT_EQ(sqlite3_exec(made, statements.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
    return path;
  }
  std::string written(const std::string& bytes) const {
    std::ofstream(folder_.file("a.db3"), std::ios::binary) << bytes;
    return folder_.file("a.db3");
  }

  TemporaryFolder folder_;
};

TEST_F(Rosbag2, FromMemoryIsTheSameAsFromAFile) {
  const RecordedLog log = parse_log("a.db3", read_text_file(foreign("humble.db3")));
  EXPECT_EQ(log.measurements.size(), 6u);
  EXPECT_EQ(log.format, "ROS 2 bag");
}

TEST_F(Rosbag2, InAJournalOfItsOwnIsReadWithoutWritingBesideIt) {
  std::string bytes = read_text_file(foreign("humble.db3"));
  bytes[18] = bytes[19] = '\2';  // as a recorder leaves it that writes ahead
  const std::string path = written(bytes);
  EXPECT_EQ(load_log(path).measurements.size(), 6u);
  EXPECT_EQ(folder_.files(), 1u);
  EXPECT_EQ(parse_log("a.db3", bytes).measurements.size(), 6u);
}

TEST_F(Rosbag2, WithoutItsTablesIsRefused) {
  EXPECT_INPUT_ERROR(load_log(database("CREATE TABLE something(x)")),
                     "a.db3: is no ROS 2 bag that can be read; SQLite says: no such table: topics; "
                     "fetch or copy the file again");
  EXPECT_INPUT_ERROR(load_log(database("CREATE TABLE topics(id,name,type,serialization_format)")),
                     "SQLite says: no such table: messages");
}

TEST_F(Rosbag2, RunsNothingThatSomebodyElseHasPutIntoIt) {
  const std::string endless =
      "CREATE TABLE topics(id,name,type,serialization_format);"
      "CREATE VIEW messages AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i+1 FROM n)"
      "SELECT i AS topic_id, i AS timestamp, 'x' AS data FROM n;";
  EXPECT_INPUT_ERROR(load_log(database(endless)), "is no ROS 2 bag that can be read");
}

TEST_F(Rosbag2, AScanWithOtherFieldsIsRefusedWhereItTellsThem) {
  std::string bytes = read_text_file(foreign("iron.db3"));
  const std::string field = "float32 angle_min";
  ASSERT_NE(bytes.find(field), bytes.npos);
  for (std::size_t at = 0; (at = bytes.find(field, at)) != bytes.npos; ++at)
    bytes.replace(at, field.size(), "float64 angle_min");
  EXPECT_INPUT_ERROR(load_log(written(bytes)),
                     "'/scan' is called 'sensor_msgs/msg/LaserScan', but its messages have other "
                     "fields than those of ROS by that name");
}

TEST_F(Rosbag2, APartThatIsBrokenFromItsBeginningOnDoesNotHideTheOthers) {
  const std::string whole = read_text_file(foreign("humble.db3"));
  std::ofstream(folder_.file("a_0.db3"), std::ios::binary) << whole.substr(0, 700);
  std::ofstream(folder_.file("a_1.db3"), std::ios::binary) << whole;
  const RecordedLog log = load_log(folder_.file("."));
  EXPECT_EQ(log.measurements.size(), 6u);
  ASSERT_EQ(log.warnings.size(), 1u);
  EXPECT_THAT(to_string(log.warnings[0]), AllOf(HasSubstr("a part of it cannot be read, "),
                                                HasSubstr("a_0.db3: is no ROS 2 bag")));
}

TEST_F(Rosbag2, DamagedInTheMiddleHasWhatStandsBefore) {
  std::string bytes = read_text_file(foreign("humble.db3"));
  const std::size_t page = 512;
  const std::size_t last = bytes.rfind("laser") / page * page;
  bytes.replace(last, page, page, '\xff');
  try {
    const RecordedLog log = load_log(written(bytes));
    EXPECT_LT(log.measurements.size(), 6u);
    EXPECT_FALSE(log.warnings.empty());
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.db3"));
  }
  EXPECT_INPUT_ERROR(load_log(written(bytes.substr(0, 700))), "a.db3");
}

}  // namespace
}  // namespace mapbed
