#include "core/failure_text.h"

#include <filesystem>
#include <new>
#include <stdexcept>

#include "core/input_error.h"

namespace mapbed {

std::string failure_text(const std::exception& error) {
  if (dynamic_cast<const InputError*>(&error) != nullptr) return error.what();
  if (const auto* of_file = dynamic_cast<const std::filesystem::filesystem_error*>(&error)) {
    const std::string from = of_file->path1().string();
    const std::string to = of_file->path2().string();
    return InputError({to.empty() ? from : from + " -> " + to},
                      "cannot be used: " + of_file->code().message(),
                      "check that it is there, its permissions and the room on its disk")
        .what();
  }
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr ||
      dynamic_cast<const std::length_error*>(&error) != nullptr) {
    return "out of memory; choose larger cells, shorter ranges, fewer particles or less of the log";
  }
  return std::string("this is a bug in mapbed, please report it: ") + error.what();
}

}  // namespace mapbed
