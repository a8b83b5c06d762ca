#pragma once

#include <string>
#include <vector>

namespace mapbed {

// Makes the folder where it is missing and makes sure, before any work is done, that files can be
// written into it. Throws InputError; `option` is what names another folder.
class OutputFolder {
 public:
  explicit OutputFolder(const std::string& folder, const std::string& option = "--out");
  ~OutputFolder();  // what was made and is still empty goes again
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

 private:
  std::vector<std::string> made_;  // the outermost first
};

}  // namespace mapbed
