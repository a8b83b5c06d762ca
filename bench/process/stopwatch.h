#pragma once

#include <chrono>

namespace mapbed {

// Wall time since it was made. For costs and for people who wait: results must not depend on it.
class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace mapbed
