#pragma once

namespace mapbed {

// What the process between this program and somebody else's needs to know. It is a fork of this
// one, which may have threads, so it calls nothing but what signal handlers may call.
struct SupervisedProgram {
  const char* path = nullptr;      // of the program
  char* const* words = nullptr;    // its name and arguments, a null pointer at the end
  const char* folder = nullptr;    // where it runs
  const char* leftover = nullptr;  // folder that goes where this program is gone; null: none
  int input = -1;                  // standard input; -1: there is nothing to be read
  int messages = -1;               // standard output and error
  int lifeline = -1;  // readable once the program shall end; its other end is closed by a kill too
  int report = -1;    // takes a SupervisorReport in the end
};

struct SupervisorReport {
  int error = 0;                   // errno where the program could not be started
  int status = 0;                  // as waitpid() tells
  double processor_seconds = 0.0;  // [s] of the program and all that it started
  double peak_memory = 0.0;        // [bytes] of the largest of these
};

// Runs the program, in a session of its own, until it ends or the lifeline does; then kills all
// that it started, to the last process, and tells how it went. Called in the child; never returns.
[[noreturn]] void supervise(const SupervisedProgram& program);

}  // namespace mapbed
