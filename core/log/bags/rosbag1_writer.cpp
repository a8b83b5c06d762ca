#include "core/log/bags/rosbag1_writer.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "core/log/bags/rosbag1_format.h"
#include "core/log/ros/ros_output.h"

namespace mapbed {
namespace {

constexpr std::size_t kChunk = 768 << 10;  // [bytes] after which the next one begins
constexpr std::size_t kBagHeader = 4096;   // [bytes] that it is padded to

using Op = Rosbag1Op;

RosOutput fields() {
  return RosOutput(RosEncoding::ros1);
}

template <class T>
std::string number(T value) {
  RosOutput out = fields();
  out.number(value);
  return std::move(out).bytes();
}

std::string stamp(std::int64_t time) {
  return number(static_cast<std::uint32_t>(time / 1'000'000'000)) +
         number(static_cast<std::uint32_t>(time % 1'000'000'000));
}

// `name=value` fields, each with its length in front.
class Header {
 public:
  explicit Header(Op op) { add("op", number(static_cast<std::uint8_t>(op))); }
  Header& add(const std::string& name, const std::string& value) {
    const std::string entry = name + "=" + value;
    text_ += number(static_cast<std::uint32_t>(entry.size())) + entry;
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::string counted(const std::string& bytes) {
  return number(static_cast<std::uint32_t>(bytes.size())) + bytes;
}

std::string record(const Header& header, const std::string& data) {
  return counted(header.text()) + counted(data);
}

std::uint32_t as_u32(std::size_t value) {
  return static_cast<std::uint32_t>(value);
}

class Writer {
 public:
  explicit Writer(const BagToWrite& bag) : bag_(bag), is_told_(bag.topics.size(), false) {}

  std::string bytes() {
    bytes_ = "#ROSBAG V2.0\n" + bag_header(0, 0);
    for (const MessageToWrite& message : bag_.messages) {
      add_message(message);
      if (chunk_.size() >= kChunk) close_chunk();
    }
    if (!chunk_.empty()) close_chunk();
    const std::size_t index = bytes_.size();
    for (std::size_t topic = 0; topic < bag_.topics.size(); ++topic) bytes_ += connection(topic);
    bytes_ += chunk_infos_;
    const std::string header = bag_header(index, chunks_);
    bytes_.replace(bytes_.find('\n') + 1, header.size(), header);
    return std::move(bytes_);
  }

 private:
  std::string bag_header(std::size_t index, std::uint32_t chunks) const {
    const Header header = Header(Op::bag_header)
                              .add("index_pos", number(static_cast<std::uint64_t>(index)))
                              .add("conn_count", number(as_u32(bag_.topics.size())))
                              .add("chunk_count", number(chunks));
    return record(header, std::string(kBagHeader - 8 - header.text().size(), ' '));
  }

  std::string connection(std::size_t topic) const {
    const TopicToWrite& told = bag_.topics[topic];
    std::string text;
    const auto add = [&text](const std::string& name, const std::string& value) {
      text += counted(name + "=" + value);
    };
    add("topic", told.name);
    add("type", std::string(type_name_of(told.type)));
    add("md5sum", std::string(md5sum_of(told.type)));
    add("message_definition", definition_of(told.type, RosEncoding::ros1));
    if (told.is_latched) add("latching", "1");
    return record(Header(Op::connection).add("conn", number(as_u32(topic))).add("topic", told.name),
                  text);
  }

  void add_message(const MessageToWrite& message) {
    const auto topic = static_cast<std::size_t>(message.topic);
    if (chunk_.empty()) first_ = last_ = message.time;
    first_ = std::min(first_, message.time);
    last_ = std::max(last_, message.time);
    if (!is_told_[topic]) chunk_ += connection(topic);
    is_told_[topic] = true;
    index_[topic].emplace_back(message.time, as_u32(chunk_.size()));
    const Header header =
        Header(Op::message).add("conn", number(as_u32(topic))).add("time", stamp(message.time));
    chunk_ += record(header, message.bytes);
  }

  void close_chunk() {
    const std::size_t begin = bytes_.size();
    bytes_ += record(
        Header(Op::chunk).add("compression", "none").add("size", number(as_u32(chunk_.size()))),
        chunk_);
    std::string counts;
    for (const auto& [topic, messages] : index_) {
      std::string entries;
      for (const auto& [time, place] : messages) entries += stamp(time) + number(place);
      bytes_ += record(Header(Op::index)
                           .add("ver", number(std::uint32_t{1}))
                           .add("conn", number(as_u32(topic)))
                           .add("count", number(as_u32(messages.size()))),
                       entries);
      counts += number(as_u32(topic)) + number(as_u32(messages.size()));
    }
    chunk_infos_ += record(Header(Op::chunk_info)
                               .add("ver", number(std::uint32_t{1}))
                               .add("chunk_pos", number(static_cast<std::uint64_t>(begin)))
                               .add("start_time", stamp(first_))
                               .add("end_time", stamp(last_))
                               .add("count", number(as_u32(index_.size()))),
                           counts);
    ++chunks_;
    chunk_.clear();
    index_.clear();
  }

  const BagToWrite& bag_;
  std::vector<bool> is_told_;  // topics whose connection is written
  std::string bytes_;
  std::string chunk_;
  std::int64_t first_ = 0;  // [ns] of the chunk
  std::int64_t last_ = 0;
  std::map<std::size_t, std::vector<std::pair<std::int64_t, std::uint32_t>>> index_;  // by topic
  std::string chunk_infos_;
  std::uint32_t chunks_ = 0;
};

}  // namespace

std::string rosbag1_bytes(const BagToWrite& bag) {
  return Writer(bag).bytes();
}

}  // namespace mapbed
