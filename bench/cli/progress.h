#pragma once

#include <cstddef>
#include <string>

#include "bench/process/stopwatch.h"

namespace mapbed {

// How far a job is, in one line, with the remaining time by the speed so far. With a bar for a
// terminal, in words for a file.
std::string progress_line(const std::string& job, std::size_t done, std::size_t total,
                          double elapsed_seconds, bool with_bar);

// Tells on stderr how far a long job is: a bar that is redrawn on a terminal, otherwise a plain
// line every ten seconds. Says nothing about jobs that take no time.
class Progress {
 public:
  Progress(std::string job, std::size_t total);
  ~Progress();  // clears the bar
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance_to(std::size_t done);

 private:
  std::string job_;
  std::size_t total_;
  bool terminal_;
  bool drawn_ = false;
  Stopwatch since_start_;
  double last_ = 0.0;  // [s] since then
};

}  // namespace mapbed
