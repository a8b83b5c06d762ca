#pragma once

#include <string>
#include <vector>

#include "core/interrupted.h"

namespace mapbed {

// A program of somebody else's, to be run once.
struct ChildCommand {
  std::vector<std::string> words;  // the program and its arguments, as they are: no shell
  std::string folder;              // where it runs
  std::string messages;            // file for what it writes to standard output and error
  double limit = 0.0;              // [s] of wall time; 0: none
  std::string leftover = {};       // folder that goes with it where this program is killed
  int input = -1;                  // open file that it reads from; -1: it reads nothing
};

// How it ended, and what it needed with all that it started.
struct ChildEnd {
  bool timed_out = false;
  int error = 0;                   // errno where it could not be started
  int status = 0;                  // its exit status
  int signal = 0;                  // that ended it; 0: none
  double wall_seconds = 0.0;       // [s]
  double processor_seconds = 0.0;  // [s]
  double peak_memory = 0.0;        // [bytes] of the largest process; 0: it was over too soon

  bool is_success() const { return !timed_out && error == 0 && status == 0 && signal == 0; }
};

// "ended with exit status 3", "was ended by signal 11 (Segmentation fault)", …
std::string text_of(const ChildEnd& end, double limit);

// Waits until it has ended, by itself or because of the limit. Nothing that it started is left
// then, nor where this program is killed. Throws Interrupted where `goes_on` says no, and
// InputError where the system gives no process.
ChildEnd run_child(const ChildCommand& command, const GoesOn& goes_on = {});

// The file that a program's name stands for: the first in PATH that can be run, or the name itself
// where it has a '/'; absolute. Empty where there is none.
std::string program_in_path(const std::string& name);

}  // namespace mapbed
