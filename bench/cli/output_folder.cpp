#include "bench/cli/output_folder.h"

#include <cstring>
#include <filesystem>
#include <system_error>

#include <unistd.h>

#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

// Those that are missing, the outermost first.
std::vector<std::string> missing_folders(const fs::path& folder) {
  std::vector<std::string> missing;
  std::error_code error;
  for (fs::path at = folder; !at.empty() && !fs::exists(at, error); at = at.parent_path()) {
    missing.insert(missing.begin(), at.string());
  }
  return missing;
}

}  // namespace

OutputFolder::OutputFolder(const std::string& folder, const std::string& option) {
  const std::string remedy = "choose another folder with " + option;
  const std::vector<std::string> missing = missing_folders(folder);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError({folder}, "cannot be made: " + error.message(), remedy);
  if (!fs::is_directory(folder, error)) {
    throw InputError({folder}, "is a file, not a folder", remedy);
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    throw InputError({folder}, std::string("cannot be written into: ") + std::strerror(errno),
                     remedy);
  }
  made_ = missing;
}

OutputFolder::~OutputFolder() {
  for (; !made_.empty(); made_.pop_back()) {
    if (rmdir(made_.back().c_str()) != 0) return;
  }
}

}  // namespace mapbed
