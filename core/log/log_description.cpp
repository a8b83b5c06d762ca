#include "core/log/log_description.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "core/config/config_node.h"
#include "core/data_path.h"
#include "core/file/hash.h"
#include "core/log/public_log.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

StoredFile stored_file_of(const ConfigNode& node) {
  const StoredFile stored{node.at("file").text(), checksum_of(node.at("sha256"))};
  const fs::path path = fs::path(stored.file).lexically_normal();
  const char* const remedy = "give it relative to the folder MAPBED_DATA or to this file";
  if (path.is_absolute())
    throw InputError(node.at("file").place(), "the file's path must not be absolute", remedy);
  if (!path.has_filename() || *path.begin() == "..")
    throw InputError(node.at("file").place(), "the file's path must not lead out of the folder",
                     remedy);
  return stored;
}

// What to type, or to do.
std::string way_to_get(const LogDescription& description) {
  if (!can_be_fetched(description)) return description.fetch;
  const fs::path path = fs::absolute(description.yaml_path).lexically_normal();
  const bool is_shipped = portable_path(path.string()).starts_with("scenarios/logs/");
  const std::string name = is_shipped ? path.stem().string() : description.yaml_path;
  return "'mapbed fetch " + name + "'";
}

void check_described(const InputFile& file, const LogDescription& description,
                     const StoredFile& stored) {
  if (is_described(file, description, stored)) return;
  throw InputError({file.path},
                   fmt::format("is not the file that {} describes: its SHA-256 is {}…, not {}…",
                               fs::path(description.yaml_path).filename().string(),
                               file.sha256.substr(0, 12), stored.sha256.substr(0, 12)),
                   "fetch it again (" + way_to_get(description) + "), or map it by its own path");
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

std::vector<const StoredFile*> stored_files(const LogDescription& description) {
  std::vector<const StoredFile*> files;
  for (const StoredFile* stored : {&description.log, &description.relations,
                                   &description.relations_odometry, &description.reference}) {
    if (!stored->file.empty()) files.push_back(stored);
  }
  return files;
}

bool can_be_fetched(const LogDescription& description) {
  const PublicLog log = load_public_log(description.yaml_path);
  const auto files = stored_files(description);
  return std::all_of(files.begin(), files.end(), [&log](const StoredFile* stored) {
    return log.making(stored->file) != nullptr;
  });
}

bool is_described(const InputFile& file, const LogDescription& description,
                  const StoredFile& stored) {
  if (file.sha256 == stored.sha256) return true;
  const PublicLog log = load_public_log(description.yaml_path);
  const MadeFile* const made = log.making(stored.file);
  if (made == nullptr) return false;
  try {
    return sha256_of_content(file.path) == made->content;
  } catch (const InputError&) {  // damaged
    return false;
  }
}

InputFile find_stored(const LogDescription& description, const StoredFile& stored,
                      HashedFiles& files) {
  const std::string place = place_of(description, stored);
  if (!place.empty()) {
    const InputFile& file = files.at(place);
    check_described(file, description, stored);
    return file;
  }
  const std::string kind = stored.file == description.log.file ? "log" : "file";
  throw InputError({description.yaml_path},
                   fmt::format("its {} '{}' is not here", kind, stored.file),
                   fmt::format("get it ({}) and set MAPBED_DATA to the folder that holds '{}'",
                               way_to_get(description), stored.file));
}

bool is_here(const LogDescription& description) {
  const auto files = stored_files(description);
  return std::all_of(files.begin(), files.end(), [&](const StoredFile* stored) {
    return !place_of(description, *stored).empty();
  });
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
