#pragma once

#include <string>

#include "core/log/bags/bag_messages.h"

namespace mapbed {

// The SQLite file of a ROS 2 bag, as bytes; the tables are those of its schema version 3 (Humble),
// which later releases read too.
std::string rosbag2_bytes(const BagToWrite& bag);

// What stands beside it in the folder of the bag: metadata.yaml.
std::string rosbag2_metadata(const BagToWrite& bag, const std::string& file_name);

}  // namespace mapbed
