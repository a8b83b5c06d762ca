#include "core/log/log_description.h"

#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "core/config/config_node.h"
#include "core/log/sha256.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

bool is_checksum(const std::string& text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

void check_checksum(const std::string& path, const LogDescription& description) {
  const std::string found = sha256_of_file(path);
  if (found == description.sha256) return;
  throw InputError({path},
                   fmt::format("is not the file that {} describes: its SHA-256 is {}…, not {}…",
                               fs::path(description.yaml_path).filename().string(),
                               found.substr(0, 12), description.sha256.substr(0, 12)),
                   "fetch it again (" + description.fetch + "), or map it by its own path");
}

}  // namespace

LogDescription load_log_description(const std::string& yaml_path) {
  const ConfigNode file = load_config(yaml_path);
  LogDescription result;
  result.yaml_path = yaml_path;
  result.about = file.at("about").text();
  result.file = file.at("file").text();
  result.sha256 = file.at("sha256").text();
  result.source = file.at("source").text();
  result.licence = file.at("licence").text();
  result.fetch = file.at("fetch").text();
  result.robot = file.at("robot").text();
  result.laser = file.at("laser").text();
  if (const ConfigNode* pieces = file.find("pieces")) result.pieces = pieces->texts();
  if (const ConfigNode* log = file.find("log")) read_options(*log, options_of(result.options));
  file.check_all_used("log description");
  if (!is_checksum(result.sha256))
    throw InputError(file.at("sha256").place(), "a SHA-256 has 64 hexadecimal digits, a to f small",
                     "sha256sum prints it");
  if (fs::path(result.file).is_absolute())
    throw InputError(file.at("file").place(), "the file's path must not be absolute",
                     "give it relative to the folder MAPBED_DATA or to this file");
  return result;
}

std::string find_log(const LogDescription& description) {
  std::vector<fs::path> places;
  const char* const data = std::getenv("MAPBED_DATA");
  if (data != nullptr && *data != '\0') places.push_back(fs::path(data) / description.file);
  places.push_back(fs::path(description.yaml_path).parent_path() / description.file);
  for (const fs::path& place : places) {
    if (!fs::is_regular_file(place)) continue;
    check_checksum(place.string(), description);
    return place.string();
  }
  throw InputError({description.yaml_path},
                   fmt::format("its log '{}' is not here", description.file),
                   fmt::format("get it ({}) and set MAPBED_DATA to the folder that holds '{}'",
                               description.fetch, description.file));
}

RecordedLog open_log(const std::string& path, const Settings& settings) {
  LogOptions options;
  std::string log = path;
  if (path.ends_with(".yaml")) {
    const LogDescription description = load_log_description(path);
    options = description.options;
    log = find_log(description);
  }
  apply(settings, options_of(options), "log");
  return load_log(log, options);
}

}  // namespace mapbed
