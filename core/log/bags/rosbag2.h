#pragma once

#include <string>
#include <string_view>

#include "core/interrupted.h"
#include "core/log/bags/bag_log.h"

namespace mapbed {

// The SQLite files (.db3) of ROS 2 bags, whole or each of their messages packed by zstd.
class Rosbag2Reader {
 public:
  static constexpr std::string_view kFormat = "ROS 2 bag";
  static bool fits(std::string_view beginning) { return beginning.starts_with("SQLite format 3"); }

  explicit Rosbag2Reader(BagLog& log) : log_(log) {}
  // The bytes of a file that is not on the disk.
  void add(std::string_view piece);
  void finish();

 private:
  BagLog& log_;
  std::string bytes_;
};

// A file on the disk, of which no more than a page is in memory.
void read_rosbag2_file(const std::string& path, BagLog& log, const GoesOn& goes_on = {});

}  // namespace mapbed
