#pragma once

#include <string>

namespace mapbed {

// An empty folder for a program of somebody else's, among the system's temporary ones ($TMPDIR);
// gone, with all that is in it, in the end.
class WorkFolder {
 public:
  WorkFolder();  // throws InputError where it cannot be made
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  std::string path(const std::string& name) const;  // of a file in it; "." for itself

 private:
  std::string path_;
};

}  // namespace mapbed
