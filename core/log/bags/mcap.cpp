#include "core/log/bags/mcap.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/file/hash.h"
#include "core/file/unpack.h"
#include "core/log/bags/mcap_format.h"

namespace mapbed {
namespace {

using Kind = McapRecord;

constexpr std::size_t kRecordHeader = 9;  // [bytes] kind and length

RosEncoding encoding_of(std::string_view of_message, std::string_view of_schema) {
  if (of_message == "ros1") return RosEncoding::ros1;
  if (of_message == "cdr" && (of_schema == "ros2msg" || of_schema == "ros2idl"))
    return RosEncoding::cdr;
  return RosEncoding::other;
}

}  // namespace

void McapReader::add(std::string_view piece) {
  if (is_at_end_ || is_stopped_) return;
  buffer_.add(piece, [this](std::string_view bytes) { return read_records(bytes); });
}

std::size_t McapReader::read_records(std::string_view bytes) {
  std::size_t used = 0;
  if (!has_magic_) {
    if (bytes.size() < kMagic.size()) return 0;
    has_magic_ = true;
    used = kMagic.size();
  }
  while (!is_at_end_ && !is_stopped_) {
    ByteInput in(bytes.substr(used));
    const auto kind = in.number<std::uint8_t>();
    const std::uint64_t size = in.u64();
    if (in.ok() && (kind == 0 || size > log_.max_bytes())) {
      damaged("record");
      return used;
    }
    const std::string_view content = in.take(size);
    if (!in.ok()) {
      if (depth_ == 0) buffer_.want(kRecordHeader + static_cast<std::size_t>(size));
      return used;
    }
    read(kind, content);
    used += in.position();
  }
  return bytes.size();
}

void McapReader::read(std::uint8_t kind, std::string_view content) {
  switch (static_cast<Kind>(kind)) {
    case Kind::schema:
      return read_schema(content);
    case Kind::channel:
      return read_channel(content);
    case Kind::message:
      return read_message(content);
    case Kind::chunk:
      return depth_ == 0 ? read_chunk(content, true) : damaged("chunk");
    case Kind::data_end:
    case Kind::footer:
      is_at_end_ = depth_ == 0;
      return;
    default:
      return;
  }
}

void McapReader::read_schema(std::string_view content) {
  ByteInput in(content);
  const auto id = in.number<std::uint16_t>();
  Schema schema;
  schema.name = in.counted();
  schema.encoding = in.counted();
  schema.definition = in.counted();
  if (!in.ok()) return damaged("record");
  schemas_.try_emplace(id, std::move(schema));
}

void McapReader::read_channel(std::string_view content) {
  ByteInput in(content);
  const auto id = in.number<std::uint16_t>();
  const auto schema_id = in.number<std::uint16_t>();
  BagTopic topic;
  topic.name = in.counted();
  const std::string_view encoding = in.counted();
  if (!in.ok()) return damaged("record");
  if (topic_of_channel_.contains(id)) return;
  const auto found = schemas_.find(schema_id);
  const Schema schema = found == schemas_.end() ? Schema{} : found->second;
  topic.type = schema.name.empty() ? "no type" : schema.name;
  topic.encoding = encoding_of(encoding, schema.encoding);
  // Another language for the same: not compared.
  if (schema.encoding != "ros2idl") topic.definition = schema.definition;
  topic_of_channel_[id] = log_.add_topic(topic);
}

void McapReader::read_message(std::string_view content) {
  ByteInput in(content);
  const auto channel = in.number<std::uint16_t>();
  in.u32();  // sequence
  const double time = seconds_of(in.number<std::int64_t>());
  in.u64();  // publish_time
  if (!in.ok()) return damaged("record");
  const auto topic = topic_of_channel_.find(channel);
  if (topic == topic_of_channel_.end()) return log_.remark("message of no topic: left out");
  log_.add_message(topic->second, time, in.rest());
}

void McapReader::read_chunk(std::string_view content, bool is_whole) {
  ByteInput in(content);
  in.u64();  // first stamp
  in.u64();  // last stamp
  const std::uint64_t size = in.u64();
  const std::uint32_t checksum = in.u32();
  const std::string_view packing = in.counted();
  const std::uint64_t packed_size = in.u64();
  if (!in.ok()) return damaged("chunk");
  std::string_view bytes = is_whole ? in.take(packed_size) : in.rest();
  if (!in.ok()) return damaged("chunk");
  Unpacked unpacked;
  if (packing == "lz4" || packing == "zstd") {
    const auto most = static_cast<std::size_t>(std::min<std::uint64_t>(size, log_.max_bytes()));
    unpacked = packing == "lz4" ? unpack_lz4(bytes, most) : unpack_zstd(bytes, most);
    bytes = unpacked.bytes;
    if (is_whole && !unpacked.is_whole)
      log_.remark("damaged chunk: what could be unpacked was read");
    is_whole = is_whole && unpacked.is_whole;
  } else if (!packing.empty()) {
    return log_.remark("chunk packed by " + in_quotes(packing) + ": left out");
  }
  if (is_whole && checksum != 0 && crc32(bytes) != checksum)
    return log_.remark("damaged chunk, its checksum is another one: left out");
  ++depth_;
  const std::size_t used = read_records(bytes);
  if (is_whole && used < bytes.size()) damaged("chunk");
  --depth_;
}

// What stood before counts, and what follows a chunk.
void McapReader::damaged(const char* part) {
  is_stopped_ = depth_ == 0;
  log_.remark(fmt::format("damaged {}: left out with the rest of its {}", part,
                          depth_ == 0 ? "file" : "chunk"));
}

void McapReader::finish() {
  if (is_at_end_ || is_stopped_) return;
  log_.remark("is cut short: read up to there");
  ByteInput in(buffer_.rest());
  const auto kind = in.number<std::uint8_t>();
  in.u64();
  if (in.ok() && static_cast<Kind>(kind) == Kind::chunk) read_chunk(in.rest(), false);
}

}  // namespace mapbed
