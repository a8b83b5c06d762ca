#include "core/log/bags/rosbag2_writer.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <sqlite3.h>

#include "core/check.h"
#include "core/config/yaml_scalar.h"
#include "core/log/bags/qos_profile.h"

namespace mapbed {
namespace {

constexpr const char* kTables =
    "CREATE TABLE schema(schema_version INTEGER PRIMARY KEY,ros_distro TEXT NOT NULL);"
    "CREATE TABLE metadata(id INTEGER PRIMARY KEY,metadata_version INTEGER NOT NULL,"
    "metadata TEXT NOT NULL);"
    "CREATE TABLE topics(id INTEGER PRIMARY KEY,name TEXT NOT NULL,type TEXT NOT NULL,"
    "serialization_format TEXT NOT NULL,offered_qos_profiles TEXT NOT NULL);"
    "CREATE TABLE messages(id INTEGER PRIMARY KEY,topic_id INTEGER NOT NULL,"
    "timestamp INTEGER NOT NULL,data BLOB NOT NULL);"
    "CREATE INDEX timestamp_idx ON messages (timestamp ASC);"
    "INSERT INTO schema(schema_version,ros_distro) VALUES (3,'humble');";

struct Close {
  void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  void operator()(unsigned char* bytes) const { sqlite3_free(bytes); }
};
using Database = std::unique_ptr<sqlite3, Close>;

void run(const Database& database, const char* statements) {
  CHECK(sqlite3_exec(database.get(), statements, nullptr, nullptr, nullptr) == SQLITE_OK);
}

class Insert {
 public:
  Insert(const Database& database, const char* statement) {
    sqlite3_stmt* made = nullptr;
    CHECK(sqlite3_prepare_v2(database.get(), statement, -1, &made, nullptr) == SQLITE_OK);
    statement_.reset(made);
  }

  Insert& number(std::int64_t value) {
    sqlite3_bind_int64(statement_.get(), ++column_, value);
    return *this;
  }
  Insert& text(const std::string& value) {
    sqlite3_bind_text64(statement_.get(), ++column_, value.data(), value.size(), SQLITE_STATIC,
                        SQLITE_UTF8);
    return *this;
  }
  Insert& blob(const std::string& value) {
    sqlite3_bind_blob64(statement_.get(), ++column_, value.data(), value.size(), SQLITE_STATIC);
    return *this;
  }
  void row() {
    CHECK(sqlite3_step(statement_.get()) == SQLITE_DONE);
    sqlite3_reset(statement_.get());
    column_ = 0;
  }

 private:
  std::unique_ptr<sqlite3_stmt, Close> statement_;
  int column_ = 0;
};

std::string ros2_name_of(RosType type) {
  std::string name(type_name_of(type));
  return name.insert(name.find('/'), "/msg");
}

void fill(const Database& database, const BagToWrite& bag) {
  Insert topics(database,
                "INSERT INTO topics(id,name,type,serialization_format,offered_qos_profiles) "
                "VALUES (?,?,?,'cdr',?)");
  std::int64_t id = 0;
  for (const TopicToWrite& topic : bag.topics) {
    const std::string type = ros2_name_of(topic.type);
    const std::string profile = qos_profile(topic.is_latched);
    topics.number(++id).text(topic.name).text(type).text(profile).row();
  }
  Insert messages(database, "INSERT INTO messages(topic_id,timestamp,data) VALUES (?,?,?)");
  for (const MessageToWrite& message : bag.messages)
    messages.number(message.topic + 1).number(message.time).blob(message.bytes).row();
}

struct Span {
  std::int64_t first = 0;  // [ns]
  std::int64_t length = 0;
};

Span span_of(const BagToWrite& bag) {
  if (bag.messages.empty()) return {};
  const auto [first, last] =
      std::minmax_element(bag.messages.begin(), bag.messages.end(),
                          [](const auto& a, const auto& b) { return a.time < b.time; });
  return {first->time, last->time - first->time};
}

}  // namespace

std::string rosbag2_bytes(const BagToWrite& bag) {
  sqlite3* made = nullptr;
  CHECK(sqlite3_open_v2(":memory:", &made, SQLITE_OPEN_READWRITE, nullptr) == SQLITE_OK);
  const Database database(made);
  run(database, kTables);
  run(database, "BEGIN");
  fill(database, bag);
  run(database, "COMMIT");
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, Close> bytes(
      sqlite3_serialize(database.get(), "main", &size, 0));
  CHECK(bytes != nullptr);
  return {reinterpret_cast<const char*>(bytes.get()), static_cast<std::size_t>(size)};
}

std::string rosbag2_metadata(const BagToWrite& bag, const std::string& file_name) {
  const Span span = span_of(bag);
  const std::vector<long> counts = bag.counts();
  std::string topics;
  for (std::size_t i = 0; i < bag.topics.size(); ++i) {
    std::string profile = qos_profile(bag.topics[i].is_latched);
    for (std::size_t at = 0; (at = profile.find('\n', at)) != profile.npos; at += 2)
      profile.replace(at, 1, "\\n");
    topics += fmt::format(
        "    - topic_metadata:\n        name: {}\n        type: {}\n"
        "        serialization_format: cdr\n        offered_qos_profiles: \"{}\"\n"
        "      message_count: {}\n",
        bag.topics[i].name, ros2_name_of(bag.topics[i].type), profile, counts[i]);
  }
  const std::string file = yaml_scalar(file_name);
  return fmt::format(
      "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: sqlite3\n"
      "  duration:\n    nanoseconds: {}\n  starting_time:\n    nanoseconds_since_epoch: {}\n"
      "  message_count: {}\n  topics_with_message_count:\n{}"
      "  compression_format: \"\"\n  compression_mode: \"\"\n  relative_file_paths:\n    - {}\n"
      "  files:\n    - path: {}\n      starting_time:\n        nanoseconds_since_epoch: {}\n"
      "      duration:\n        nanoseconds: {}\n      message_count: {}\n",
      span.length, span.first, bag.messages.size(), topics, file, file, span.first, span.length,
      bag.messages.size());
}

}  // namespace mapbed
