// Whatever the bytes: a trajectory in order that reads back from what is written of it, or an
// InputError.

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "core/geometry/tum_file.h"
#include "core/input_error.h"
#include "core/testing/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mapbed;
  Trajectory trajectory;
  try {
    trajectory = parse_trajectory("fuzz", fuzz_text(data, size));
  } catch (const InputError&) {
    return 0;
  }
  CHECK(std::is_sorted(trajectory.begin(), trajectory.end(),
                       [](const auto& a, const auto& b) { return a.time < b.time; }));
  for (const auto& [time, pose] : trajectory) {
    CHECK(std::isfinite(time) && std::isfinite(pose.x) && std::isfinite(pose.y));
    CHECK(std::abs(pose.theta) < 3.1416);
  }
  CHECK(parse_trajectory("again", tum_text(trajectory)).size() == trajectory.size());
  return 0;
}
