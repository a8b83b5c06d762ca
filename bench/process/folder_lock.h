#pragma once

#include <string>

namespace mapbed {

// A folder that one program at a time works in. The lock is the system's (flock), so it ends with
// the program, however that ends.
class FolderLock {
 public:
  explicit FolderLock(const std::string& folder);  // InputError where another one has it
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::string path_;
  int file_ = -1;
};

}  // namespace mapbed
