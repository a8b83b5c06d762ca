#include "core/log/log_writer.h"

#include <filesystem>

#include "core/file/atomic_file.h"
#include "core/log/bags/bag_messages.h"
#include "core/log/bags/mcap_writer.h"
#include "core/log/bags/rosbag1_writer.h"
#include "core/log/bags/rosbag2_writer.h"
#include "core/log/dialects/carmen_log.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

// "drive" of the folder "runs/drive/".
std::string name_of_folder(const std::string& path) {
  const fs::path folder =
      fs::path(path).has_filename() ? fs::path(path) : fs::path(path).parent_path();
  return folder.filename().string();
}

void write_rosbag2(const std::string& path, const RecordedLog& log) {
  const BagToWrite bag = bag_messages(log, RosEncoding::cdr);
  const std::vector<std::string> files = files_of_log(path, LogFormat::ros2);
  fs::create_directories(path);
  write_file(files[0], rosbag2_bytes(bag));
  write_file(files[1], rosbag2_metadata(bag, fs::path(files[0]).filename().string()));
}

}  // namespace

const std::vector<std::string>& log_format_names() {
  static const std::vector<std::string> names{"carmen", "ros1", "ros2", "mcap"};
  return names;
}

LogFormat log_format_of(const std::string& path) {
  if (path.ends_with(".bag")) return LogFormat::ros1;
  if (path.ends_with(".mcap")) return LogFormat::mcap;
  return LogFormat::carmen;
}

std::vector<std::string> files_of_log(const std::string& path, LogFormat format) {
  if (format != LogFormat::ros2) return {path};
  const fs::path folder(path);
  return {(folder / (name_of_folder(path) + "_0.db3")).string(),
          (folder / "metadata.yaml").string()};
}

void write_log(const std::string& path, const RecordedLog& log, LogFormat format) {
  switch (format) {
    case LogFormat::carmen:
      return write_carmen_log(path, log);
    case LogFormat::ros1:
      return write_file(path, rosbag1_bytes(bag_messages(log, RosEncoding::ros1)));
    case LogFormat::ros2:
      return write_rosbag2(path, log);
    case LogFormat::mcap:
      return write_file(path, mcap_bytes(bag_messages(log, RosEncoding::cdr)));
  }
}

}  // namespace mapbed
