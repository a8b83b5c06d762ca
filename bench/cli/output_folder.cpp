#include "bench/cli/output_folder.h"

#include <cstring>
#include <filesystem>
#include <system_error>

#include <unistd.h>

#include "core/input_error.h"

namespace mapbed {

void make_output_folder(const std::string& folder) {
  const std::string remedy = "choose another folder with --out";
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError({folder}, "cannot be made: " + error.message(), remedy);
  if (!std::filesystem::is_directory(folder, error)) {
    throw InputError({folder}, "is a file, not a folder", remedy);
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    throw InputError({folder}, std::string("cannot be written into: ") + std::strerror(errno),
                     remedy);
  }
}

}  // namespace mapbed
