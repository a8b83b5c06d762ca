#include "bench/process/thread_limit.h"

#include <algorithm>
#include <thread>

#include <tbb/global_control.h>

namespace mapbed {

// Made in its place: a limit of TBB's ends with any copy of it.
struct ThreadLimit::Control {
  explicit Control(int threads)
      : limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)) {}
  tbb::global_control limit;
};

ThreadLimit::ThreadLimit(int threads) {
  control_ = std::make_unique<Control>(threads > 0 ? threads : processors());
}

ThreadLimit::~ThreadLimit() = default;

int processors() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace mapbed
