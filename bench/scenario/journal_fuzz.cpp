// Whatever is found as a journal: runs of this configuration to go on from, or an InputError; and
// what is written behind them is found again.

#include "bench/scenario/journal.h"
#include "core/check.h"
#include "core/input_error.h"
#include "core/testing/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mapbed;
  const std::string path = fuzz_file("journal", data, size);
  try {
    std::size_t found = 0;
    {
      Journal journal(path, "identity", 1);
      found = journal.found().size();
      journal.append({{.run = 7, .values = {0.5}}, {.run = 7}});
    }
    CHECK(Journal(path, "identity", 1).found().size() == found + 1);
  } catch (const InputError&) {
    return 0;
  }
  return 0;
}
