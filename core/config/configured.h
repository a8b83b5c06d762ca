#pragma once

#include <functional>
#include <string>

#include "core/file/input_file.h"

namespace mapbed {

// Settings bound once: what holds, defaults included, and what is made with it. Nothing is read
// from text or disk afterwards. `Made` is the type of a call, World(), so that a method, a world
// and an experiment are bound alike; `make` may be called as often as one likes, by any thread.
template <class Made>
struct Configured {
  std::string complete_yaml;  // as it stands beside the results
  std::function<Made> make;
  InputFiles files = {};  // that were read for it
  // Why nothing can be made of it: a file that is no part of the program is not here. Else empty.
  std::string missing = {};
};

}  // namespace mapbed
