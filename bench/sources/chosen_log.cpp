#include "bench/sources/chosen_log.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/data_path.h"
#include "core/log/log_description.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

// The name of a log in scenarios/logs, and not a path. A folder of that name, as of earlier
// results, is in nobody's way.
bool is_name_of_log(const std::string& log) {
  if (log.find_first_of("/.") != std::string::npos) return false;
  if (!fs::exists(log)) return true;
  const std::vector<std::string> names = data_names("scenarios/logs");
  return fs::is_directory(log) && std::find(names.begin(), names.end(), log) != names.end();
}

}  // namespace

std::vector<std::string> endings_of_logs() {
  return {".yaml", ".log", ".clf", ".bag", ".mcap", ".log.gz", ".clf.gz"};
}

ChosenLog chosen_log(const std::string& log) {
  std::string description = log;
  if (is_name_of_log(log)) {
    description =
        find_data_file("log", "scenarios/logs", log, {.endings = endings_of_logs()}).string();
  }
  if (!description.ends_with(".yaml")) {
    return {log, {}, fs::is_regular_file(log) ? input_file(log).sha256 : ""};
  }
  const LogDescription found = load_log_description(description);
  HashedFiles files;
  const InputFile file = find_stored(found, found.log, files);
  return {file.path, found.options, file.sha256};
}

}  // namespace mapbed
