#pragma once

namespace mapbed {

// While one of these lives, Ctrl-C (and a request to terminate) is noted instead of ending the
// program, so that a job can stop between two steps and keep what it has. The second one ends the
// program at once. One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  bool was_interrupted() const;
};

}  // namespace mapbed
