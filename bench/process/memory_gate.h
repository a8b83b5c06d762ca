#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>

namespace mapbed {

// Lets in no more jobs at once than memory allows: one always, another where what the system has
// left is twice of what a job has taken so far. Decides when jobs start, never what comes of them.
class MemoryGate {
 public:
  // [bytes] that the system has left, and that this program has taken at most so far.
  MemoryGate(std::function<double()> available, std::function<double()> taken);

  void enter();  // waits until there is room
  void leave();
  bool has_room() const;  // for one more job

 private:
  std::function<double()> available_;
  std::function<double()> taken_;
  double taken_before_;  // [bytes] when there was no job yet
  int inside_ = 0;
  int most_inside_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
};

double available_memory();  // [bytes] infinite where the system does not tell

}  // namespace mapbed
