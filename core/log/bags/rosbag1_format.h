#pragma once

#include <cstdint>

namespace mapbed {

// What a record of a bag of ROS 1 (2.0) is, as its field `op` tells.
enum class Rosbag1Op : std::uint8_t {
  message = 2,
  bag_header = 3,
  index = 4,
  chunk = 5,
  chunk_info = 6,
  connection = 7
};

}  // namespace mapbed
