#include "bench/process/foreign_files.h"

#include <algorithm>
#include <filesystem>

#include "core/input_error.h"

namespace mapbed {

namespace fs = std::filesystem;

void refuse_foreign(const std::string& folder, const std::vector<std::string>& coming,
                    const std::vector<std::string>& ours) {
  for (const std::string& path : coming) {
    const fs::path file = fs::path(folder) / path;
    if (!fs::exists(fs::symlink_status(file))) continue;
    if (std::find(ours.begin(), ours.end(), path) == ours.end()) refuse_foreign(file.string());
  }
}

void refuse_foreign(const std::string& path) {
  throw InputError({path}, "was not written by mapbed, and would be written over",
                   "move it away, or choose another folder");
}

void refuse_of_another_log(const std::string& path, const std::string& held, const std::string& log,
                           const std::string& detail, const std::string& remedy) {
  throw InputError({path}, "holds " + held + " of another log, " + in_quotes(log) + detail, remedy);
}

}  // namespace mapbed
