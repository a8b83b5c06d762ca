#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/file/unpack.h"

namespace mapbed {

enum class UnpackState { more, done, damaged };

struct UnpackStep {
  std::size_t written = 0;  // [bytes]
  UnpackState state = UnpackState::more;
};

// Calls `step(output, room)` until it is done, is damaged or gives nothing any more.
template <class Step>
Unpacked unpack_in_steps(std::size_t max_bytes, Step&& step) {
  constexpr std::size_t kFirst = 1 << 18;  // [bytes]
  Unpacked result;
  std::size_t size = 0;
  while (true) {
    // One byte more than allowed shows that there is more.
    if (size == result.bytes.size()) {
      if (size > max_bytes) break;
      result.bytes.resize(std::min(max_bytes + 1, std::max(kFirst, 2 * size)));
    }
    const UnpackStep made = step(result.bytes.data() + size, result.bytes.size() - size);
    size += made.written;
    result.is_whole = made.state == UnpackState::done;
    if (made.state != UnpackState::more || made.written == 0) break;
  }
  if (size > max_bytes) result.is_whole = false;
  result.bytes.resize(std::min(size, max_bytes));
  return result;
}

}  // namespace mapbed
