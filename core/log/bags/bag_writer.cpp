#include "core/log/bags/bag_writer.h"

#include <filesystem>
#include <system_error>

#include "core/file/atomic_file.h"
#include "core/input_error.h"
#include "core/log/bags/bag_messages.h"
#include "core/log/bags/mcap_writer.h"
#include "core/log/bags/rosbag1_writer.h"
#include "core/log/bags/rosbag2_writer.h"

namespace mapbed {

namespace fs = std::filesystem;

void write_rosbag1(const std::string& path, const RecordedLog& log) {
  write_file(path, rosbag1_bytes(bag_messages(log, RosEncoding::ros1)));
}

void write_mcap(const std::string& path, const RecordedLog& log) {
  write_file(path, mcap_bytes(bag_messages(log, RosEncoding::cdr)));
}

std::array<std::string, 2> files_of_rosbag2(const std::string& folder) {
  fs::path path(folder);
  if (!path.has_filename()) path = path.parent_path();  // "drive/"
  return {(path / (path.filename().string() + "_0.db3")).string(),
          (path / "metadata.yaml").string()};
}

void write_rosbag2(const std::string& folder, const RecordedLog& log) {
  const BagToWrite bag = bag_messages(log, RosEncoding::cdr);
  const auto [database, metadata] = files_of_rosbag2(folder);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError({folder}, "cannot be made: " + error.message());
  write_file(database, rosbag2_bytes(bag));
  write_file(metadata, rosbag2_metadata(bag, fs::path(database).filename().string()));
}

}  // namespace mapbed
