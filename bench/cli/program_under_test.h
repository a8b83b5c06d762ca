#pragma once

#include <string>
#include <vector>

namespace mapbed {

// How a run of the program ended.
struct Outcome {
  int status = 0;  // exit status; 128 + signal where a signal ended it
  std::string out;
  std::string err;
};

// Runs the program that was built with the tests, in `folder`, and waits for it.
Outcome run_mapbed(const std::vector<std::string>& arguments, const std::string& folder = ".");

// The same under `sh -c`, with $MAPBED for the program.
Outcome run_shell(const std::string& script, const std::string& folder = ".");

}  // namespace mapbed
