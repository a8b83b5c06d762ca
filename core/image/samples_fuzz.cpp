// Whatever the bytes: a picture, PNG or PGM, has all its pixels, or there is an InputError.

#include "core/check.h"
#include "core/image/samples.h"
#include "core/input_error.h"
#include "core/testing/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mapbed;
  try {
    const Samples samples = samples_from(fuzz_text(data, size), "fuzz");
    CHECK(samples.width > 0 && samples.height > 0 && samples.channels > 0);
    CHECK(samples.values.size() == static_cast<std::size_t>(samples.width) *
                                       static_cast<std::size_t>(samples.height) *
                                       static_cast<std::size_t>(samples.channels));
    for (const std::uint16_t value : samples.values) CHECK(value <= samples.white);
  } catch (const InputError&) {
    return 0;
  }
  return 0;
}
