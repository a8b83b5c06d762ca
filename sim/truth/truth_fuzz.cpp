// Whatever the bytes, packed or not: a truth, or an InputError.

#include "core/input_error.h"
#include "core/testing/fuzz_input.h"
#include "sim/truth/truth_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mapbed;
  try {
    (void)load_truth(fuzz_file("fuzz.truth", data, size));
  } catch (const InputError&) {
    return 0;
  }
  return 0;
}
