#pragma once

#include <string>

namespace mapbed {

// A folder that one program at a time works in. The lock is the system's (flock), so it ends with
// the program, however that ends.
class FolderLock {
 public:
  // Waits `patience` [s] for another one that has it; InputError where it still does. `option` is
  // what names another folder.
  explicit FolderLock(const std::string& folder, double patience = 0.0,
                      const std::string& option = "--out");
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  // Whether a program has it at this moment. Makes no file.
  static bool is_taken(const std::string& folder);

 private:
  std::string path_;
  int file_ = -1;
};

}  // namespace mapbed
