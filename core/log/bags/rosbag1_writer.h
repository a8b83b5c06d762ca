#pragma once

#include <string>

#include "core/log/bags/bag_messages.h"

namespace mapbed {

// A bag of ROS 1, version 2.0, with chunks that are not packed, and its index.
std::string rosbag1_bytes(const BagToWrite& bag);

}  // namespace mapbed
