#include "bench/process/memory_gate.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <limits>
#include <string>

#include "core/check.h"

namespace mapbed {
namespace {

constexpr auto kLookAgain = std::chrono::milliseconds(200);  // other programs free memory too

}  // namespace

MemoryGate::MemoryGate(std::function<double()> available, std::function<double()> taken)
    : available_(std::move(available)), taken_(std::move(taken)), taken_before_(taken_()) {}

bool MemoryGate::has_room() const {
  if (inside_ == 0) return true;
  const double of_a_job = (taken_() - taken_before_) / most_inside_;
  return available_() >= 2.0 * of_a_job;
}

void MemoryGate::enter() {
  std::unique_lock lock(mutex_);
  while (!has_room()) changed_.wait_for(lock, kLookAgain);
  most_inside_ = std::max(most_inside_, ++inside_);
}

void MemoryGate::leave() {
  const std::scoped_lock lock(mutex_);
  CHECK(inside_ > 0);
  --inside_;
  changed_.notify_one();
}

double available_memory() {
  std::ifstream file("/proc/meminfo");
  for (std::string name; file >> name;) {
    double kibibytes = 0.0;
    if (name == "MemAvailable:" && file >> kibibytes) return 1024.0 * kibibytes;
    file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace mapbed
