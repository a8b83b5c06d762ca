#include "bench/process/folder_lock.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "bench/process/stopwatch.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr std::chrono::milliseconds kAskAgain{20};

// The file may have been removed, with its lock, between opening and locking it.
bool is_still_there(int file, const std::string& path) {
  struct stat opened {};
  struct stat named {};
  return fstat(file, &opened) == 0 && stat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino;
}

}  // namespace

FolderLock::FolderLock(const std::string& folder, double patience, const std::string& option)
    : path_(folder + "/.lock") {
  const Stopwatch waited;
  for (;;) {
    file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (file_ < 0) {
      throw InputError({path_}, std::string("cannot be written: ") + std::strerror(errno),
                       "choose another folder with " + option);
    }
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
      const int error = errno;
      close(file_);
      if (error != EWOULDBLOCK) {
        throw InputError({path_}, std::string("cannot be locked: ") + std::strerror(error),
                         "choose a folder of a file system that has locks with " + option);
      }
      if (waited.seconds() < patience) {
        std::this_thread::sleep_for(kAskAgain);
        continue;
      }
      throw InputError({folder}, "another run is at work in this folder",
                       "wait for it to end, or choose another folder with " + option);
    }
    if (is_still_there(file_, path_)) return;
    close(file_);
  }
}

bool FolderLock::is_taken(const std::string& folder) {
  const int file = open((folder + "/.lock").c_str(), O_RDWR | O_CLOEXEC);
  if (file < 0) return false;
  const bool is_locked = flock(file, LOCK_EX | LOCK_NB) != 0;
  close(file);
  return is_locked;
}

FolderLock::~FolderLock() {
  unlink(path_.c_str());
  close(file_);
}

}  // namespace mapbed
