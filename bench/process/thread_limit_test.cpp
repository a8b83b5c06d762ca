#include "bench/process/thread_limit.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace mapbed {
namespace {

std::size_t threads_allowed() {
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}

TEST(ThreadLimit, HoldsAsLongAsItLives) {
  const std::size_t before = threads_allowed();
  {
    const ThreadLimit limit(1);
    EXPECT_EQ(threads_allowed(), 1U);
  }
  EXPECT_EQ(threads_allowed(), before);
}

}  // namespace
}  // namespace mapbed
