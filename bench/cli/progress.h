#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace mapbed {

// How far a job is, in one line, with the remaining time by the speed so far; before the first step
// and after the last one, and where nobody knows how many there are, with the time so far. With a
// bar for a terminal, in words for a file.
std::string progress_line(const std::string& job, std::size_t done,
                          std::optional<std::size_t> total, double elapsed_seconds, bool with_bar);

// Tells on stderr that a long job goes on and how far it is: a line that is drawn again twice
// a second on a terminal, otherwise a line more every ten seconds, also while nothing advances.
// Says nothing about jobs that take no time.
class Progress {
 public:
  explicit Progress(std::string job, std::optional<std::size_t> total = std::nullopt);
  Progress(std::string job, std::optional<std::size_t> total, double pause);  // [s] between lines
  ~Progress();  // clears the line of a terminal
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance_to(std::size_t done);

 private:
  struct Ticker;
  std::unique_ptr<Ticker> ticker_;
};

// What the work gives; it says nothing itself, for the line would be in its way.
template <class Work>
auto while_told(const std::string& job, const Work& work) {
  const Progress progress(job);
  return work();
}

}  // namespace mapbed
