#include "bench/sources/shared_work.h"

#include <atomic>
#include <stdexcept>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

namespace mapbed {
namespace {

TEST(SharedWork, IsDoneOnceForEachKeyHoweverManyAskForIt) {
  SharedWork shared;
  std::atomic<int> made = 0;
  std::atomic<int> sum = 0;
  tbb::parallel_for(0, 40, [&](int i) {
    sum += shared.once<int>(i % 2 == 0 ? "even" : "odd", [&] {
      ++made;
      return i % 2;
    });
  });
  EXPECT_EQ(made, 2);
  EXPECT_EQ(sum, 20);
}

TEST(SharedWork, IsTriedAgainWhereItFailed) {
  SharedWork shared;
  const std::function<int()> fails = []() -> int { throw std::runtime_error("no"); };
  EXPECT_THROW((void)shared.once<int>("a", fails), std::runtime_error);
  EXPECT_EQ(shared.once<int>("a", [] { return 7; }), 7);
}

// A task that waits for its own parts must not begin another that needs the same.
TEST(SharedWork, MayItselfRunOnSeveralThreads) {
  SharedWork shared;
  std::atomic<int> parts = 0;
  tbb::parallel_for(0, 16, [&](int) {
    (void)shared.once<int>("sum", [&] {
      tbb::parallel_for(0, 200, [&](int) { ++parts; });
      return parts.load();
    });
  });
  EXPECT_EQ(parts, 200);
}

}  // namespace
}  // namespace mapbed
