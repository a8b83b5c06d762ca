#include "bench/sources/run_input.h"

namespace mapbed {

RunInput shortened(RunInput input, double longest) {
  if (longest <= 0.0 || input.log.empty()) return input;
  const double end = time_of(input.log.front()) + longest;
  const auto is_later = [end](const Measurement& m) { return time_of(m) > end; };
  std::erase_if(input.log, is_later);
  std::erase_if(input.clean, is_later);
  return input;
}

}  // namespace mapbed
