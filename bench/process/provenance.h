#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace mapbed {

// What a result was made with and on.
struct Provenance {
  std::vector<std::string> command;
  std::string runs_sha256;  // of identity_of() the plan
  std::string program_sha256;
  std::uint64_t seed = 0;
  int runs = 0;
  int runs_done_before = 0;   // by earlier starts that were interrupted
  int recordings_needed = 0;  // by all runs
  int recordings_made = 0;    // by the last start
  int threads = 0;
  double wall_seconds = 0.0;       // of the last start
  double processor_seconds = 0.0;  // of all runs and recordings
  // Name and checksum of each table of the runs.
  std::vector<std::pair<std::string, std::string>> tables_sha256;
};

// Text in UTF-8, whatever the command is.
std::string to_json(const Provenance& provenance);

std::string sha256_of_program();  // of the file that is running

}  // namespace mapbed
