#include "core/log/bags/mcap_writer.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "core/file/hash.h"
#include "core/log/bags/mcap.h"
#include "core/log/bags/mcap_format.h"
#include "core/log/bags/qos_profile.h"
#include "core/log/ros/ros_output.h"

namespace mapbed {
namespace {

using Kind = McapRecord;

constexpr std::size_t kChunk = 1 << 20;  // [bytes] after which the next one begins

// Numbers and strings of MCAP stand as those of ROS 1 do.
RosOutput fields() {
  return RosOutput(RosEncoding::ros1);
}

void add_record(std::string& bytes, Kind kind, RosOutput&& content) {
  const std::string text = std::move(content).bytes();
  RosOutput head = fields();
  head.number(static_cast<std::uint8_t>(kind));
  head.number(static_cast<std::uint64_t>(text.size()));
  bytes += std::move(head).bytes();
  bytes += text;
}

std::uint16_t number_of(std::size_t topic) {
  return static_cast<std::uint16_t>(topic + 1);  // 0 means none
}

struct Chunk {
  std::string records;
  std::int64_t first = 0;  // [ns]
  std::int64_t last = 0;
  // Time and place within the chunk of each message, by channel.
  std::map<std::uint16_t, std::vector<std::pair<std::int64_t, std::uint64_t>>> index;
};

class Writer {
 public:
  explicit Writer(const BagToWrite& bag) : bag_(bag), sent_(bag.topics.size(), 0) {}

  std::string bytes() {
    bytes_ = McapReader::kMagic;
    RosOutput header = fields();
    header.text(bag_.encoding == RosEncoding::cdr ? "ros2" : "ros1");
    header.text("mapbed");
    add_record(bytes_, Kind::header, std::move(header));
    add_topics();
    for (const MessageToWrite& message : bag_.messages) {
      add_message(message);
      if (chunk_.records.size() >= kChunk) close_chunk();
    }
    if (!chunk_.records.empty()) close_chunk();
    RosOutput end = fields();
    end.number(std::uint32_t{0});  // checksum: none
    add_record(bytes_, Kind::data_end, std::move(end));
    add_summary();
    return std::move(bytes_);
  }

 private:
  void add_schemas() {
    for (std::size_t topic = 0; topic < bag_.topics.size(); ++topic) {
      std::string type(type_name_of(bag_.topics[topic].type));
      if (bag_.encoding == RosEncoding::cdr) type.insert(type.find('/'), "/msg");
      RosOutput schema = fields();
      schema.number(number_of(topic));
      schema.text(type);
      schema.text(bag_.encoding == RosEncoding::cdr ? "ros2msg" : "ros1msg");
      schema.text(definition_of(bag_.topics[topic].type, bag_.encoding));
      add_record(bytes_, Kind::schema, std::move(schema));
    }
  }

  void add_channels() {
    for (std::size_t topic = 0; topic < bag_.topics.size(); ++topic) {
      RosOutput metadata = fields();
      metadata.text("offered_qos_profiles");
      metadata.text(qos_profile(bag_.topics[topic].is_latched));
      RosOutput channel = fields();
      channel.number(number_of(topic));
      channel.number(number_of(topic));  // its schema
      channel.text(bag_.topics[topic].name);
      channel.text(bag_.encoding == RosEncoding::cdr ? "cdr" : "ros1");
      channel.text(std::move(metadata).bytes());
      add_record(bytes_, Kind::channel, std::move(channel));
    }
  }

  void add_topics() {
    add_schemas();
    add_channels();
  }

  void add_message(const MessageToWrite& message) {
    const auto topic = static_cast<std::size_t>(message.topic);
    if (chunk_.records.empty()) chunk_.first = chunk_.last = message.time;
    chunk_.first = std::min(chunk_.first, message.time);
    chunk_.last = std::max(chunk_.last, message.time);
    chunk_.index[number_of(topic)].emplace_back(message.time, chunk_.records.size());
    RosOutput record = fields();
    record.number(number_of(topic));
    record.number(sent_[topic]++);
    record.number(message.time);  // when it was recorded
    record.number(message.time);  // when it was sent
    record.raw(message.bytes);
    add_record(chunk_.records, Kind::message, std::move(record));
  }

  void close_chunk() {
    const std::size_t begin = bytes_.size();
    RosOutput chunk = fields();
    chunk.number(chunk_.first);
    chunk.number(chunk_.last);
    chunk.number(static_cast<std::uint64_t>(chunk_.records.size()));
    chunk.number(crc32(chunk_.records));
    chunk.text("");  // not packed
    chunk.number(static_cast<std::uint64_t>(chunk_.records.size()));
    chunk.raw(chunk_.records);
    add_record(bytes_, Kind::chunk, std::move(chunk));
    const std::size_t end = bytes_.size();
    const std::string offsets = add_message_indices();

    RosOutput index = fields();
    index.number(chunk_.first);
    index.number(chunk_.last);
    index.number(static_cast<std::uint64_t>(begin));
    index.number(static_cast<std::uint64_t>(end - begin));
    index.text(offsets);
    index.number(static_cast<std::uint64_t>(bytes_.size() - end));
    index.text("");
    index.number(static_cast<std::uint64_t>(chunk_.records.size()));
    index.number(static_cast<std::uint64_t>(chunk_.records.size()));
    add_record(chunk_indices_, Kind::chunk_index, std::move(index));
    ++chunks_;
    chunk_ = {};
  }

  // Returns where they are, by channel.
  std::string add_message_indices() {
    RosOutput offsets = fields();
    for (const auto& [channel, messages] : chunk_.index) {
      offsets.number(channel);
      offsets.number(static_cast<std::uint64_t>(bytes_.size()));
      RosOutput entries = fields();
      for (const auto& [time, place] : messages) {
        entries.number(time);
        entries.number(place);
      }
      RosOutput index = fields();
      index.number(channel);
      index.text(std::move(entries).bytes());
      add_record(bytes_, Kind::message_index, std::move(index));
    }
    return std::move(offsets).bytes();
  }

  RosOutput statistics() const {
    const auto [first, last] =
        std::minmax_element(bag_.messages.begin(), bag_.messages.end(),
                            [](const auto& a, const auto& b) { return a.time < b.time; });
    RosOutput counts = fields();
    for (std::size_t topic = 0; topic < sent_.size(); ++topic) {
      counts.number(number_of(topic));
      counts.number(static_cast<std::uint64_t>(sent_[topic]));
    }
    RosOutput out = fields();
    out.number(static_cast<std::uint64_t>(bag_.messages.size()));
    out.number(static_cast<std::uint16_t>(bag_.topics.size()));
    out.number(static_cast<std::uint32_t>(bag_.topics.size()));
    out.number(std::uint32_t{0});  // attachments
    out.number(std::uint32_t{0});  // metadata
    out.number(chunks_);
    out.number(bag_.messages.empty() ? 0 : first->time);
    out.number(bag_.messages.empty() ? 0 : last->time);
    out.text(std::move(counts).bytes());
    return out;
  }

  void add_summary() {
    const std::size_t begin = bytes_.size();
    std::string groups;
    const auto close_group = [&](Kind kind, std::size_t group) {
      RosOutput offset = fields();
      offset.number(static_cast<std::uint8_t>(kind));
      offset.number(static_cast<std::uint64_t>(group));
      offset.number(static_cast<std::uint64_t>(bytes_.size() - group));
      if (bytes_.size() > group) add_record(groups, Kind::summary_offset, std::move(offset));
    };
    add_schemas();
    close_group(Kind::schema, begin);
    const std::size_t channels = bytes_.size();
    add_channels();
    close_group(Kind::channel, channels);
    const std::size_t counts = bytes_.size();
    add_record(bytes_, Kind::statistics, statistics());
    close_group(Kind::statistics, counts);
    const std::size_t chunks = bytes_.size();
    bytes_ += chunk_indices_;
    close_group(Kind::chunk_index, chunks);
    const std::size_t offsets_begin = bytes_.size();
    bytes_ += groups;
    RosOutput footer = fields();
    footer.number(static_cast<std::uint64_t>(begin));
    footer.number(static_cast<std::uint64_t>(offsets_begin));
    footer.number(std::uint32_t{0});  // checksum: none
    add_record(bytes_, Kind::footer, std::move(footer));
    bytes_ += McapReader::kMagic;
  }

  const BagToWrite& bag_;
  std::string bytes_;
  std::vector<std::uint32_t> sent_;  // messages, by topic
  Chunk chunk_;
  std::string chunk_indices_;
  std::uint32_t chunks_ = 0;
};

}  // namespace

std::string mcap_bytes(const BagToWrite& bag) {
  return Writer(bag).bytes();
}

}  // namespace mapbed
