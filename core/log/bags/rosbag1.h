#pragma once

#include <cstdint>
#include <map>
#include <string_view>

#include "core/log/bags/bag_log.h"
#include "core/log/bags/piece_buffer.h"

namespace mapbed {

// Bags of ROS 1, version 2.0, with chunks that are not packed, or by bz2 or lz4. They are read from
// front to back without their index, so that a bag that was never closed has all that is in it.
class Rosbag1Reader {
 public:
  static constexpr std::string_view kFormat = "ROS 1 bag";
  static bool fits(std::string_view beginning) { return beginning.starts_with("#ROSBAG V"); }

  explicit Rosbag1Reader(BagLog& log) : log_(log) {}
  void add(std::string_view piece);
  void finish();

 private:
  struct Record;
  std::size_t read_records(std::string_view bytes);  // how many bytes were used
  void read_version(std::string_view line);
  void read(const Record& record);
  void read_chunk(const Record& record);
  void read_connection(const Record& record);
  void read_message(const Record& record);
  void damaged(const char* part);

  BagLog& log_;
  PieceBuffer buffer_;
  std::map<std::uint32_t, int> topic_of_connection_;
  bool has_version_ = false;
  bool is_stopped_ = false;  // at damage outside chunks
  bool has_index_ = false;
  int depth_ = 0;  // 1: within a chunk
};

}  // namespace mapbed
