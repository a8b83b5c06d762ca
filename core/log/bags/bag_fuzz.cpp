// Whatever bytes a bag consists of, it becomes a log in order, which can be written as a bag and
// read again, or an InputError.

#include <algorithm>
#include <optional>

#include "core/check.h"
#include "core/log/bags/bag_messages.h"
#include "core/log/bags/mcap.h"
#include "core/log/bags/mcap_writer.h"
#include "core/log/bags/rosbag1.h"
#include "core/log/bags/rosbag2.h"
#include "core/testing/fuzz_input.h"

namespace {

using namespace mapbed;

LogOptions options() {
  LogOptions options;
  options.max_text = 1e8;
  options.bag.echo = ChosenEcho::strongest;
  return options;
}

template <class Reader>
std::optional<RecordedLog> read(std::string_view bytes) {
  try {
    BagLog log("fuzz", options());
    Reader reader(log);
    reader.add(bytes.substr(0, bytes.size() / 2));
    reader.add(bytes.substr(bytes.size() / 2));
    reader.finish();
    return log.finish("bag");
  } catch (const InputError&) {
    return {};
  }
}

std::optional<RecordedLog> read_any(std::string_view bytes) {
  if (Rosbag1Reader::fits(bytes)) return read<Rosbag1Reader>(bytes);
  if (Rosbag2Reader::fits(bytes)) return read<Rosbag2Reader>(bytes);
  return read<McapReader>(bytes);
}

void write_and_read(const RecordedLog& log) {
  try {
    const BagToWrite bag = bag_messages(log, RosEncoding::cdr);
    const auto again = read<McapReader>(mcap_bytes(bag));
    // Several lasers have to be named.
    CHECK(again.has_value() || bag.topics.empty() || log.lasers.size() > 1);
  } catch (const InputError&) {
    return;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto log = read_any(fuzz_text(data, size));
  if (!log) return 0;
  CHECK(std::is_sorted(log->measurements.begin(), log->measurements.end(),
                       [](const auto& a, const auto& b) { return time_of(a) < time_of(b); }));
  write_and_read(*log);
  return 0;
}
