#pragma once

#include <optional>
#include <string>
#include <vector>

namespace mapbed {

// A run of the program that was to be killed.
struct KilledRun {
  bool was_killed = false;  // else it came to its end before
  int status = 0;           // exit status then
  int calls = 0;            // system calls that change files, of all its threads
};

// Runs the program that was built with the tests in `folder`, and kills it when it is about to make
// its `nth` system call that changes files: one that makes, opens for writing from the beginning,
// writes, syncs, cuts, renames, links or removes (output to a terminal apart). The call is not
// made. Nothing where the system lets no program trace another.
std::optional<KilledRun> run_killed_at(int nth, const std::vector<std::string>& arguments,
                                       const std::string& folder);

}  // namespace mapbed
