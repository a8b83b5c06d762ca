#pragma once

#include <string>

#include "core/log/log_file.h"

namespace mapbed {

// "intel.clf.gz" -> "intel", "run.1.log" -> "run.1"
std::string name_of_log(const std::string& path);

// What a log that was read in `seconds` holds: on stdout, its warnings on stderr.
void print_log(const std::string& path, const RecordedLog& log, double seconds);

}  // namespace mapbed
