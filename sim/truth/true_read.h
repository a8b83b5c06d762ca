#pragma once

#include <cstdint>

namespace mapbed {

// Why a reader tells of a tag.
enum class ReadMechanism : std::int32_t {
  direct,         // the tag answered, on the straight way
  reflection,     // it answered, by a mirror above all
  ghost,          // it did not: a broken answer of nobody's looks like its
  wrong_antenna,  // another antenna read it
};

// What is behind one read of a log.
struct TruthRead {
  double time = 0.0;         // [s] the round's own stamp
  std::int32_t antenna = 0;  // that the log names
  std::int32_t tag = 0;      // index into the truth's tags
  ReadMechanism mechanism = ReadMechanism::direct;
};

}  // namespace mapbed
