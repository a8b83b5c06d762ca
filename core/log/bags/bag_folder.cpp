#include "core/log/bags/bag_folder.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <tuple>

#include <fmt/format.h>

#include "core/config/config_node.h"
#include "core/file/parse_number.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEndings[] = {".db3", ".mcap", ".db3.zstd", ".mcap.zstd"};

// "drive_12.db3": the part 12 of the bag "drive".
struct Part {
  std::string bag;
  int number = -1;  // none
  std::string path;
};

bool is_bag_name(const std::string& name) {
  return std::any_of(std::begin(kEndings), std::end(kEndings),
                     [&](std::string_view ending) { return name.ends_with(ending); });
}

Part part_of(const fs::path& path) {
  const std::string name = path.filename().string();
  Part part{name.substr(0, name.find('.')), -1, path.string()};
  const std::size_t line = part.bag.rfind('_');
  int number = 0;
  if (line == std::string::npos || !parse_number(part.bag.substr(line + 1), number)) return part;
  part.bag.resize(line);
  part.number = number;
  return part;
}

std::vector<Part> parts_in(const std::string& folder) {
  std::vector<Part> parts;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.is_regular_file(ignored) && is_bag_name(entry.path().filename().string()))
      parts.push_back(part_of(entry.path()));
  }
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    return std::tie(a.bag, a.number, a.path) < std::tie(b.bag, b.number, b.path);
  });
  return parts;
}

// The files that metadata.yaml names; those that are not there are in the remark.
BagFolder by_metadata(const std::string& folder, const std::string& yaml) {
  BagFolder result;
  std::string missing;
  const ConfigNode file = load_config(yaml);
  const ConfigNode& about = file.at("rosbag2_bagfile_information");
  for (const std::string& name : about.at("relative_file_paths").texts()) {
    // Older releases wrote the folder's name in front.
    const fs::path path = fs::path(folder) / fs::path(name).filename();
    if (fs::is_regular_file(path))
      result.files.push_back(path.string());
    else
      missing += (missing.empty() ? "" : ", ") + in_quotes(name);
  }
  if (!missing.empty()) result.remark = missing + " of metadata.yaml: not there";
  file.use_all();
  return result;
}

}  // namespace

BagFolder bag_folder(const std::string& path) {
  const std::vector<Part> parts = parts_in(path);
  BagFolder result;
  if (parts.empty()) return result;
  const fs::path yaml = fs::path(path) / "metadata.yaml";
  if (fs::is_regular_file(yaml)) {
    try {
      result = by_metadata(path, yaml.string());
    } catch (const InputError&) {
      result.remark = "metadata.yaml cannot be read: the files are taken by their names";
    }
    if (!result.files.empty()) return result;
  }
  for (const Part& part : parts) {
    if (part.bag != parts.front().bag)
      throw InputError({path},
                       fmt::format("holds several bags: {}, {}",
                                   fs::path(parts.front().path).filename().string(),
                                   fs::path(part.path).filename().string()),
                       "name one of them");
    result.files.push_back(part.path);
  }
  return result;
}

}  // namespace mapbed
