#pragma once

#include <array>
#include <string>

// Logs as bags; bag_messages.h says of which topics. All throw InputError where the file cannot be
// written, or where a bag cannot say what is in the log.

namespace mapbed {

struct RecordedLog;

void write_rosbag1(const std::string& path, const RecordedLog& log);
void write_mcap(const std::string& path, const RecordedLog& log);

// Bags of ROS 2 are folders: "drive" gets drive_0.db3 and metadata.yaml.
void write_rosbag2(const std::string& folder, const RecordedLog& log);
std::array<std::string, 2> files_of_rosbag2(const std::string& folder);  // paths, in this order

}  // namespace mapbed
