#include "bench/thread_limit.h"

#include <algorithm>
#include <thread>

#include <tbb/global_control.h>

namespace mapbed {

struct ThreadLimit::Control {
  tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads) {
  const auto processors = static_cast<int>(std::thread::hardware_concurrency());
  const int count = threads > 0 ? threads : std::max(1, processors);
  control_ = std::make_unique<Control>(Control{tbb::global_control(
      tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count))});
}

ThreadLimit::~ThreadLimit() = default;

}  // namespace mapbed
