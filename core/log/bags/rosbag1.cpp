#include "core/log/bags/rosbag1.h"

#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "core/file/unpack.h"
#include "core/log/bags/rosbag1_format.h"

namespace mapbed {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kLongestHeader = 1 << 20;  // [bytes] of a record
constexpr std::size_t kMostConnections = 1 << 16;

using Op = Rosbag1Op;

// The value of a field in a header of `name=value` fields; empty where it is not there.
std::string_view field(std::string_view header, std::string_view name) {
  ByteInput in(header);
  while (!in.at_end() && in.ok()) {
    const std::string_view entry = in.counted();
    if (entry.size() > name.size() && entry.starts_with(name) && entry[name.size()] == '=')
      return entry.substr(name.size() + 1);
  }
  return {};
}

template <class T>
std::optional<T> number(std::string_view header, std::string_view name) {
  ByteInput in(field(header, name));
  const T value = in.number<T>();
  return in.ok() ? std::optional(value) : std::nullopt;
}

// Seconds and nanoseconds, [s].
double time_of_field(std::string_view header, std::string_view name) {
  ByteInput in(field(header, name));
  const std::int64_t seconds = in.u32();
  return seconds_of(1'000'000'000 * seconds + in.u32());
}

// [bytes] Some bags of 2010 tell a wrong length of their index; the number of its entries is right.
std::uint32_t size_of_data(std::string_view header, std::uint32_t told) {
  constexpr std::uint32_t kEntry = 12;  // [bytes] time and place of a message
  if (field(header, "op") != "\x04"sv || number<std::uint32_t>(header, "ver") != 1u) return told;
  const auto entries = number<std::uint32_t>(header, "count");
  return entries && *entries <= told / kEntry ? *entries * kEntry : told;
}

}  // namespace

struct Rosbag1Reader::Record {
  std::string_view header;
  std::string_view data;
  std::uint32_t size = 0;  // of the data, as it is told; more than there is where the bag is cut
};

void Rosbag1Reader::add(std::string_view piece) {
  if (is_stopped_) return;
  buffer_.add(piece, [this](std::string_view bytes) { return read_records(bytes); });
}

void Rosbag1Reader::read_version(std::string_view line) {
  has_version_ = true;
  if (line == "#ROSBAG V2.0"sv) return;
  throw InputError({log_.name()},
                   "is a ROS 1 bag of another version: " + in_quotes(line.substr(0, 20)),
                   "bags of version 2.0 are read; `rosbag fix` makes one of it");
}

std::size_t Rosbag1Reader::read_records(std::string_view bytes) {
  std::size_t used = 0;
  if (!has_version_) {
    const std::size_t end = bytes.find('\n');
    if (end == bytes.npos && bytes.size() < 100) return 0;
    read_version(bytes.substr(0, end));
    used = end + 1;
  }
  while (!is_stopped_) {
    ByteInput in(bytes.substr(used));
    const std::string_view header = in.counted();
    const std::uint32_t size = size_of_data(header, in.u32());
    const bool has_no_header =
        in.ok() ? field(header, "op").size() != 1 : header.empty() && in.left() > kLongestHeader;
    if (has_no_header || size > log_.max_bytes()) {
      damaged("record");
      return used;
    }
    const std::size_t begin = in.position();
    const std::string_view data = in.take(size);
    if (!in.ok()) {
      if (depth_ == 0) buffer_.want(begin + size);
      return used;
    }
    read({header, data, size});
    used += in.position();
  }
  return bytes.size();
}

void Rosbag1Reader::read(const Record& record) {
  switch (static_cast<Op>(field(record.header, "op")[0])) {
    case Op::message:
      return read_message(record);
    case Op::connection:
      return read_connection(record);
    case Op::chunk:
      return depth_ == 0 ? read_chunk(record) : damaged("chunk");
    case Op::index:
    case Op::chunk_info:
      has_index_ = true;
      return;
    case Op::bag_header: {
      const std::string_view encryptor = field(record.header, "encryptor");
      if (!encryptor.empty())
        throw InputError({log_.name()}, "is encrypted by " + in_quotes(encryptor),
                         "decrypt it with rosbag");
      return;
    }
    default:
      return;
  }
}

void Rosbag1Reader::read_chunk(const Record& record) {
  const std::string_view packing = field(record.header, "compression");
  const std::size_t size = number<std::uint32_t>(record.header, "size").value_or(0);
  const bool is_whole = record.data.size() == record.size;
  Unpacked unpacked;
  std::string_view bytes = record.data;
  if (packing == "bz2" || packing == "lz4") {
    const std::size_t most = std::min(size, log_.max_bytes());
    unpacked = packing == "bz2" ? unpack_bzip2(bytes, most) : unpack_lz4(bytes, most);
    bytes = unpacked.bytes;
    if (is_whole && !unpacked.is_whole)
      log_.remark("damaged chunk: what could be unpacked was read");
  } else if (packing != "none") {
    return log_.remark("chunk packed by " + in_quotes(packing) + ": left out");
  }
  ++depth_;
  const std::size_t used = read_records(bytes);
  if (used < bytes.size() && is_whole && (packing == "none" || unpacked.is_whole)) damaged("chunk");
  --depth_;
}

void Rosbag1Reader::read_connection(const Record& record) {
  const auto connection = number<std::uint32_t>(record.header, "conn");
  if (!connection) return damaged("record");
  if (topic_of_connection_.contains(*connection)) return;
  if (topic_of_connection_.size() == kMostConnections) return damaged("record");
  BagTopic topic;
  topic.name = field(record.header, "topic");
  topic.type = field(record.data, "type");
  topic.encoding = RosEncoding::ros1;
  topic.md5sum = field(record.data, "md5sum");
  topic.definition = field(record.data, "message_definition");
  topic_of_connection_[*connection] = log_.add_topic(topic);
}

void Rosbag1Reader::read_message(const Record& record) {
  const auto connection = number<std::uint32_t>(record.header, "conn");
  const auto topic =
      connection ? topic_of_connection_.find(*connection) : topic_of_connection_.end();
  if (topic == topic_of_connection_.end()) return log_.remark("message of no topic: left out");
  log_.add_message(topic->second, time_of_field(record.header, "time"), record.data);
}

// What stood before counts, and what follows a chunk.
void Rosbag1Reader::damaged(const char* part) {
  is_stopped_ = depth_ == 0;
  log_.remark(fmt::format("damaged {}: left out with the rest of its {}", part,
                          depth_ == 0 ? "file" : "chunk"));
}

void Rosbag1Reader::finish() {
  if (is_stopped_) return;
  const std::string_view rest = buffer_.rest();
  if (!has_version_) read_version(rest);
  if (rest.empty()) {
    if (!has_index_) log_.remark("has no index, as if it had not been closed: all of it was read");
    return;
  }
  log_.remark("is cut short: read up to there");
  ByteInput in(rest);
  const std::string_view header = in.counted();
  const std::uint32_t size = in.u32();
  if (in.ok() && field(header, "op") == "\x05"sv) read_chunk({header, in.rest(), size});
}

}  // namespace mapbed
