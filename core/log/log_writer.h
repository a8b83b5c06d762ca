#pragma once

#include <string>
#include <vector>

#include "core/log/log_file.h"

namespace mapbed {

enum class LogFormat : int { carmen, ros1, ros2, mcap };

// "carmen", "ros1", "ros2", "mcap": in the order of LogFormat.
const std::vector<std::string>& log_format_names();

// By the ending: .bag is a bag of ROS 1, .mcap is MCAP, all others are CARMEN.
LogFormat log_format_of(const std::string& path);

// The files that write_log() makes: the path itself, or what stands in the folder of that name.
std::vector<std::string> files_of_log(const std::string& path, LogFormat format);

// Bags of ROS 2 are folders. Throws InputError where it cannot be written, or where the format
// cannot say what is in the log.
void write_log(const std::string& path, const RecordedLog& log, LogFormat format);

}  // namespace mapbed
