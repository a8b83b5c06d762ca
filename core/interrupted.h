#pragma once

#include <exception>
#include <functional>

namespace mapbed {

// Asked again and again by work that takes long; false ends it.
using GoesOn = std::function<bool()>;

// Thrown by work that was ended half-way and has nothing to give.
class Interrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "interrupted"; }
};

// Asks, where there is somebody to ask.
inline void throw_unless(const GoesOn& goes_on) {
  if (goes_on && !goes_on()) throw Interrupted();
}

}  // namespace mapbed
