// Whatever the bytes: relations of finite numbers, or an InputError.

#include <cmath>

#include "bench/metrics/relations.h"
#include "core/check.h"
#include "core/input_error.h"
#include "core/testing/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mapbed;
  try {
    const auto relations = parse_relations("fuzz", fuzz_text(data, size));
    for (const Relation& r : relations) {
      CHECK(std::isfinite(r.from_time) && std::isfinite(r.to_time));
      CHECK(std::isfinite(r.from_to.x) && std::isfinite(r.from_to.y));
    }
    (void)relations_error({{0.0, {}}, {1.0, {1.0, 0.0, 0.0}}}, relations);
  } catch (const InputError&) {
    return 0;
  }
  return 0;
}
