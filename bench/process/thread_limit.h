#pragma once

#include <memory>

namespace mapbed {

// As long as it lives, parallel loops use at most so many threads. Results do not depend on it.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);  // 0: as many as the machine has processors
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

int processors();  // that the machine has; at least 1

}  // namespace mapbed
