#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

// Stands before the TBB header of this name in builds with the thread sanitizer, which sees nothing
// of how TBB's workers wait for each other and would call all that follows a loop a race with it.
// The same loop on threads of the standard library, whose start and end it knows. Nothing else
// orders one turn of the loop after another: the counter is relaxed.
namespace tbb {

template <class Body>
void parallel_for(std::size_t first, std::size_t last, const Body& body) {
  constexpr std::size_t kThreads = 4;
  std::atomic<std::size_t> next{first};
  const auto work = [&] {
    for (;;) {
      const std::size_t i = next.fetch_add(1, std::memory_order_relaxed);
      if (i >= last) return;
      body(i);
    }
  };
  std::vector<std::thread> threads;
  const std::size_t turns = last > first ? last - first : 0;
  for (std::size_t i = 0; i < std::min(kThreads, turns); ++i) threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
}

}  // namespace tbb
