#include "core/file/input_file.h"

#include <algorithm>
#include <filesystem>

#include "core/file/file_reader.h"
#include "core/file/hash.h"

namespace mapbed {

InputFile input_file(const std::string& path) {
  check_is_file(path);
  if (!std::filesystem::is_regular_file(path)) {
    throw InputError({path}, "is a pipe or a device, which can be read only once",
                     "save what comes from it as a file");
  }
  return {std::filesystem::absolute(path).lexically_normal().string(), sha256_of_file(path)};
}

void check_unchanged(const InputFile& file) {
  if (std::filesystem::is_regular_file(file.path) && sha256_of_file(file.path) == file.sha256) {
    return;
  }
  throw InputChanged({file.path}, "has changed since the runs were planned",
                     "start again; what was done with the old file is done anew");
}

void merge(const InputFiles& more, InputFiles& all) {
  all.insert(all.end(), more.begin(), more.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
}

const InputFile& HashedFiles::at(const std::string& path) {
  const auto found = by_path_.find(path);
  return found != by_path_.end() ? found->second
                                 : by_path_.emplace(path, input_file(path)).first->second;
}

}  // namespace mapbed
