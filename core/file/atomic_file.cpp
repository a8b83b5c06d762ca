#include "core/file/atomic_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <unistd.h>

#include "core/check.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

// A new, empty file beside `path`, of a name that neither another process nor another thread has.
std::string new_file_beside(const std::string& path) {
  const fs::path target(path);
  for (int attempt = 0;; ++attempt) {
    const std::string name = "." + target.filename().string() + ".unfinished-" +
                             std::to_string(::getpid()) + "-" + std::to_string(attempt);
    const std::string unfinished = (target.parent_path() / name).string();
    const int descriptor =
        ::open(unfinished.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (descriptor >= 0) {
      ::close(descriptor);
      return unfinished;
    }
    if (errno == EEXIST) continue;
    throw InputError(SourceLocation{path},
                     "cannot be written: " + std::string(std::strerror(errno)),
                     "is there such a folder, and may you write to it?");
  }
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(path) {
  if (fs::is_directory(path))
    throw InputError(SourceLocation{path}, "is a folder", "name a file in it");
  if (fs::exists(path) && !fs::is_regular_file(path)) {
    throw InputError(SourceLocation{path}, "is not a regular file", "write to a file");
  }
  unfinished_ = new_file_beside(path);
  stream_.open(unfinished_, std::ios::binary);
}

AtomicFile::~AtomicFile() {
  if (unfinished_.empty()) return;
  stream_.close();
  std::remove(unfinished_.c_str());
}

void AtomicFile::commit() {
  CHECK(!unfinished_.empty());
  stream_.close();
  if (!stream_)
    throw InputError(SourceLocation{path_}, "cannot be written completely", "is the disk full?");
  if (std::rename(unfinished_.c_str(), path_.c_str()) != 0) {
    throw InputError(SourceLocation{path_},
                     "cannot be written: " + std::string(std::strerror(errno)));
  }
  unfinished_.clear();
}

void write_file(const std::string& path, std::string_view content) {
  AtomicFile file(path);
  file.stream().write(content.data(), static_cast<std::streamsize>(content.size()));
  file.commit();
}

}  // namespace mapbed
