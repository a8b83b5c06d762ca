#pragma once

#include <string>
#include <vector>

namespace mapbed {

struct LibraryVersion {
  std::string name;     // "Eigen3"
  std::string version;  // "3.4.0"
};

// What this program was built from; goes into `--version` and into every provenance file.
struct Version {
  std::string program;   // "0.1.0"
  std::string revision;  // "1504d2e", "1504d2e-changed" with uncommitted edits, "unknown"
  std::string compiler;  // "GNU 12.2.0"
  std::string build;     // "Release"
  std::vector<LibraryVersion> libraries;
};

const Version& version();

// As `mapbed --version` prints it: a line for the program, then one for each library.
std::string version_text();

}  // namespace mapbed
