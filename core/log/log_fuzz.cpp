// Whatever bytes it is given, and whichever dialect they are taken for, a log reader returns a log
// in order or throws InputError.

#include <algorithm>

#include "core/check.h"
#include "core/log/dialects/carmen_log.h"
#include "core/log/dialects/dialects.h"
#include "core/testing/fuzz_input.h"

namespace {

using namespace mapbed;

template <class Read>
void read_and_write(Read read) {
  try {
    const RecordedLog log = read();
    CHECK(std::is_sorted(log.measurements.begin(), log.measurements.end(),
                         [](const auto& a, const auto& b) { return time_of(a) < time_of(b); }));
    carmen_text(log);
  } catch (const InputError&) {
    return;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz_text(data, size);
  read_and_write([&] { return parse_log("fuzz", text); });
  for (const LogDialect& dialect : log_dialects()) {
    read_and_write([&] {
      const auto reader = dialect.make_reader("fuzz", {});
      reader->add(text.substr(0, text.size() / 2));
      reader->add(text.substr(text.size() / 2));
      return reader->finish();
    });
  }
  return 0;
}
