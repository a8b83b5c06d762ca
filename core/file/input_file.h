#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/input_error.h"

namespace mapbed {

// A file that something is made of, and what was in it then.
struct InputFile {
  std::string path;    // absolute
  std::string sha256;  // of the file as it stands on the disk

  auto operator<=>(const InputFile&) const = default;
};
using InputFiles = std::vector<InputFile>;

// To be taken before the file is read: one that changes in between is then seen to be another the
// next time. Throws InputError where it cannot be read.
InputFile input_file(const std::string& path);

// A file that was planned with is another one now. Not a failure of a run: all stops.
class InputChanged : public InputError {
 public:
  using InputError::InputError;
};

// Throws InputChanged, also where the file is gone.
void check_unchanged(const InputFile& file);

// Adds those that are not there yet, in the order of their paths.
void merge(const InputFiles& more, InputFiles& all);

// Large files that several parts of a plan are made of, each hashed once.
class HashedFiles {
 public:
  const InputFile& at(const std::string& path);

 private:
  std::map<std::string, InputFile> by_path_;
};

}  // namespace mapbed
