#include "bench/methods/work_folder.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include <unistd.h>

#include "core/input_error.h"

namespace mapbed {

namespace fs = std::filesystem;

WorkFolder::WorkFolder() {
  std::error_code none;
  const fs::path temporary = fs::temp_directory_path(none);
  std::string name = ((none ? fs::path("/tmp") : temporary) / "mapbed_program_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw InputError({name}, std::string("cannot be made: ") + std::strerror(errno),
                     "set TMPDIR to a folder that can be written");
  }
  path_ = fs::absolute(name).string();
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string WorkFolder::path(const std::string& name) const {
  return name == "." ? path_ : (fs::path(path_) / name).string();
}

}  // namespace mapbed
