#include "core/log/bags/rosbag2.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <sqlite3.h>

#include "core/file/unpack.h"

namespace mapbed {
namespace {

constexpr std::string_view kZstd = "\x28\xb5\x2f\xfd";

struct Close {
  void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Database = std::unique_ptr<sqlite3, Close>;

// What goes wrong with a damaged file is told by SQLite in its own words.
std::string reason_of(sqlite3* database) {
  return fmt::format("SQLite says: {}", sqlite3_errmsg(database));
}

[[noreturn]] void refuse(const BagLog& log, sqlite3* database) {
  throw InputError({log.name()}, "is no ROS 2 bag that can be read; " + reason_of(database),
                   "fetch or copy the file again");
}

class Rows {
 public:
  // None where the statement is not possible in this database.
  Rows(const Database& database, const char* statement) {
    sqlite3_stmt* made = nullptr;
    sqlite3_prepare_v2(database.get(), statement, -1, &made, nullptr);
    statement_.reset(made);
  }

  bool is_possible() const { return statement_ != nullptr; }
  bool next() {
    code_ = statement_ ? sqlite3_step(statement_.get()) : SQLITE_ERROR;
    return code_ == SQLITE_ROW;
  }
  bool ended() const { return code_ == SQLITE_DONE; }  // else: something was wrong
  std::int64_t number(int column) const { return sqlite3_column_int64(statement_.get(), column); }
  std::string_view bytes(int column) const {
    const auto* const blob =
        static_cast<const char*>(sqlite3_column_blob(statement_.get(), column));
    const int size = sqlite3_column_bytes(statement_.get(), column);
    return blob == nullptr ? std::string_view()
                           : std::string_view(blob, static_cast<unsigned>(size));
  }

 private:
  std::unique_ptr<sqlite3_stmt, Close> statement_;
  int code_ = SQLITE_OK;
};

// Of a file of somebody else's: nothing in it is run, and nothing becomes larger than allowed.
void make_safe(const Database& database, const BagLog& log) {
  const auto most = std::min<std::size_t>(log.max_bytes(), std::numeric_limits<int>::max());
  sqlite3_limit(database.get(), SQLITE_LIMIT_LENGTH, static_cast<int>(most));
  sqlite3_db_config(database.get(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(database.get(), SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(database.get(), SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_db_config(database.get(), SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
}

// By type; only bags of newer releases have them.
std::map<std::string, std::string, std::less<>> definitions_in(const Database& database) {
  std::map<std::string, std::string, std::less<>> definitions;
  Rows rows(database,
            "SELECT topic_type, encoded_message_definition FROM message_definitions "
            "WHERE encoding = 'ros2msg'");
  while (rows.next()) definitions.emplace(rows.bytes(0), rows.bytes(1));
  return definitions;
}

std::map<std::int64_t, int> topics_in(const Database& database, BagLog& log) {
  const auto definitions = definitions_in(database);
  std::map<std::int64_t, int> numbers;
  Rows rows(database, "SELECT id, name, type, serialization_format FROM topics");
  while (rows.next()) {
    BagTopic topic;
    topic.name = rows.bytes(1);
    topic.type = rows.bytes(2);
    topic.encoding = rows.bytes(3) == "cdr" ? RosEncoding::cdr : RosEncoding::other;
    const auto definition = definitions.find(topic.type);
    if (definition != definitions.end()) topic.definition = definition->second;
    numbers[rows.number(0)] = log.add_topic(topic);
  }
  if (!rows.ended()) refuse(log, database.get());
  return numbers;
}

void read(const Database& database, BagLog& log, const GoesOn& goes_on) {
  make_safe(database, log);
  const std::map<std::int64_t, int> topics = topics_in(database, log);
  // In the order of the file, so that all that stands before a damage is read.
  Rows rows(database, "SELECT topic_id, timestamp, data FROM messages");
  if (!rows.is_possible()) refuse(log, database.get());
  while (rows.next()) {
    throw_unless(goes_on);
    const auto topic = topics.find(rows.number(0));
    if (topic == topics.end()) {
      log.remark("message of no topic: left out");
      continue;
    }
    const double time = seconds_of(rows.number(1));
    const std::string_view message = rows.bytes(2);
    if (!message.starts_with(kZstd)) {
      log.add_message(topic->second, time, message);
      continue;
    }
    const Unpacked unpacked = unpack_zstd(message, log.max_bytes());
    log.add_message(topic->second, time, unpacked.bytes);
  }
  if (!rows.ended()) log.remark("is damaged: read up to there; " + reason_of(database.get()));
}

}  // namespace

void Rosbag2Reader::add(std::string_view piece) {
  bytes_ += piece;
  if (bytes_.size() > log_.max_bytes())
    throw InputError(
        {log_.name()},
        fmt::format("unpacks to more than {:.0f} MB", 1e-6 * static_cast<double>(log_.max_bytes())),
        "unpack it into a file, or raise log.max_text");
}

void Rosbag2Reader::finish() {
  // Its journal, if there is one, is not here: SQLite would look for it.
  constexpr std::size_t kVersions = 18;
  if (bytes_.size() > kVersions + 1) bytes_[kVersions] = bytes_[kVersions + 1] = '\1';
  sqlite3* made = nullptr;
  sqlite3_open_v2(":memory:", &made, SQLITE_OPEN_READWRITE, nullptr);
  const Database database(made);
  const auto size = static_cast<sqlite3_int64>(bytes_.size());
  const int code =
      sqlite3_deserialize(database.get(), "main", reinterpret_cast<unsigned char*>(bytes_.data()),
                          size, size, SQLITE_DESERIALIZE_READONLY);
  if (code != SQLITE_OK) refuse(log_, database.get());
  read(database, log_, {});
}

void read_rosbag2_file(const std::string& path, BagLog& log, const GoesOn& goes_on) {
  // Without a journal nobody writes to it: then not even the folder need be writable.
  const bool has_journal = std::filesystem::exists(path + "-wal");
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(path).string())
    uri += c == '?' || c == '#' || c == '%' ? fmt::format("%{:02x}", c) : std::string(1, c);
  if (!has_journal) uri += "?immutable=1";
  sqlite3* made = nullptr;
  const int code =
      sqlite3_open_v2(uri.c_str(), &made, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
  const Database database(made);
  if (code != SQLITE_OK) refuse(log, database.get());
  read(database, log, goes_on);
}

}  // namespace mapbed
