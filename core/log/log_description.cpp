#include "core/log/log_description.h"

#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "core/config/config_node.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

bool is_checksum(const std::string& text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

StoredFile stored_file_of(const ConfigNode& node) {
  const StoredFile stored{node.at("file").text(), node.at("sha256").text()};
  if (!is_checksum(stored.sha256))
    throw InputError(node.at("sha256").place(), "a SHA-256 has 64 hexadecimal digits, a to f small",
                     "sha256sum prints it");
  if (fs::path(stored.file).is_absolute())
    throw InputError(node.at("file").place(), "the file's path must not be absolute",
                     "give it relative to the folder MAPBED_DATA or to this file");
  return stored;
}

void check_checksum(const InputFile& file, const LogDescription& description,
                    const std::string& sha256) {
  if (file.sha256 == sha256) return;
  throw InputError({file.path},
                   fmt::format("is not the file that {} describes: its SHA-256 is {}…, not {}…",
                               fs::path(description.yaml_path).filename().string(),
                               file.sha256.substr(0, 12), sha256.substr(0, 12)),
                   "fetch it again (" + description.fetch + "), or map it by its own path");
}

// Empty where it is in none of the places.
std::string place_of(const LogDescription& description, const StoredFile& stored) {
  std::vector<fs::path> places;
  const char* const data = std::getenv("MAPBED_DATA");
  if (data != nullptr && *data != '\0') places.push_back(fs::path(data) / stored.file);
  places.push_back(fs::path(description.yaml_path).parent_path() / stored.file);
  for (const fs::path& place : places) {
    if (fs::is_regular_file(place)) return place.string();
  }
  return {};
}

}  // namespace

LogDescription load_log_description(const std::string& yaml_path) {
  const ConfigNode file = load_config(yaml_path);
  LogDescription result;
  result.yaml_path = yaml_path;
  result.about = file.at("about").text();
  result.log = stored_file_of(file);
  result.source = file.at("source").text();
  result.licence = file.at("licence").text();
  result.fetch = file.at("fetch").text();
  result.robot = file.at("robot").text();
  result.laser = file.at("laser").text();
  if (const ConfigNode* pieces = file.find("pieces")) result.pieces = pieces->texts();
  if (const ConfigNode* log = file.find("log")) read_options(*log, options_of(result.options));
  if (const ConfigNode* relations = file.find("relations")) {
    result.relations = stored_file_of(*relations);
    const ConfigNode* odometry = relations->find("odometry");
    if (odometry != nullptr) result.relations_odometry = stored_file_of(*odometry);
  }
  if (const ConfigNode* reference = file.find("reference")) {
    result.reference = stored_file_of(*reference);
  }
  file.check_all_used("log description");
  return result;
}

InputFile find_stored(const LogDescription& description, const StoredFile& stored,
                      HashedFiles& files) {
  const std::string place = place_of(description, stored);
  if (!place.empty()) {
    const InputFile& file = files.at(place);
    check_checksum(file, description, stored.sha256);
    return file;
  }
  const std::string kind = stored.file == description.log.file ? "log" : "file";
  throw InputError({description.yaml_path},
                   fmt::format("its {} '{}' is not here", kind, stored.file),
                   fmt::format("get it ({}) and set MAPBED_DATA to the folder that holds '{}'",
                               description.fetch, stored.file));
}

bool is_here(const LogDescription& description) {
  for (const StoredFile* stored : {&description.log, &description.relations,
                                   &description.relations_odometry, &description.reference}) {
    if (!stored->file.empty() && place_of(description, *stored).empty()) return false;
  }
  return true;
}

RecordedLog open_log(const std::string& path, const Settings& settings) {
  LogOptions options;
  std::string log = path;
  if (path.ends_with(".yaml")) {
    const LogDescription description = load_log_description(path);
    options = description.options;
    HashedFiles files;
    log = find_stored(description, description.log, files).path;
  }
  apply(settings, options_of(options), "log");
  return load_log(log, options);
}

}  // namespace mapbed
