#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "core/log/bags/bag_log.h"
#include "core/log/bags/piece_buffer.h"

namespace mapbed {

// MCAP, as ROS 2 and Foxglove record it: messages as CDR with definitions in ros2msg, or those of
// ROS 1; chunks that are not packed, or by lz4 or zstd. Read from front to back without the index.
class McapReader {
 public:
  static constexpr std::string_view kFormat = "MCAP";
  static constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};
  static bool fits(std::string_view beginning) { return beginning.starts_with(kMagic); }

  explicit McapReader(BagLog& log) : log_(log) {}
  void add(std::string_view piece);
  void finish();

 private:
  struct Schema {
    std::string name;
    std::string encoding;
    std::string definition;
  };

  std::size_t read_records(std::string_view bytes);  // how many bytes were used
  void read(std::uint8_t kind, std::string_view content);
  void read_schema(std::string_view content);
  void read_channel(std::string_view content);
  void read_message(std::string_view content);
  void read_chunk(std::string_view content, bool is_whole);
  void damaged(const char* part);

  BagLog& log_;
  PieceBuffer buffer_;
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, int> topic_of_channel_;
  bool has_magic_ = false;
  bool is_at_end_ = false;   // of the data; the summary repeats what stood there
  bool is_stopped_ = false;  // at damage outside chunks
  int depth_ = 0;            // 1: within a chunk
};

}  // namespace mapbed
