#pragma once

#include <string>
#include <vector>

#include "core/log/log_options.h"

namespace mapbed {

// A log, and what is known of its sensors beyond what it says itself.
struct ChosenLog {
  std::string path;
  LogOptions options;
  std::string sha256 = {};  // of the file before it is read; empty for a pipe
};

// By its path, by the path of its description (.yaml), or by its name in scenarios/logs. Throws
// InputError.
ChosenLog chosen_log(const std::string& log);

// What names of logs and of their descriptions mostly end in: ".yaml", ".log", …
std::vector<std::string> endings_of_logs();

}  // namespace mapbed
