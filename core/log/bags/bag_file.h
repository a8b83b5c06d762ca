#pragma once

#include <string>

#include "core/interrupted.h"
#include "core/log/bags/bag_log.h"

// Bags by their paths.

namespace mapbed {

// Whether it is a file that begins as a bag does, also packed by gzip or zstd, or a folder into
// which ROS 2 has recorded. Pipes are not looked into.
bool is_bag(const std::string& path);

// Reads it into the log, and returns its format: "ROS 1 bag", "ROS 2 bag" or "MCAP". Throws
// InputError where nothing in it can be read.
std::string read_bag(const std::string& path, BagLog& log, const GoesOn& goes_on = {});

}  // namespace mapbed
