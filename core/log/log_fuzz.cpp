// Whatever bytes it is given, a log reader returns a log in order or throws InputError.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/check.h"
#include "core/log/dialects/carmen_log.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mapbed;
  try {
    const RecordedLog log =
        parse_log("fuzz", std::string_view(reinterpret_cast<const char*>(data), size));
    CHECK(std::is_sorted(log.measurements.begin(), log.measurements.end(),
                         [](const auto& a, const auto& b) { return time_of(a) < time_of(b); }));
    carmen_text(log);
  } catch (const InputError&) {
    return 0;
  }
  return 0;
}
