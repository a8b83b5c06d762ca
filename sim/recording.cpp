#include "sim/recording.h"

#include <memory>
#include <utility>

#include <fmt/format.h>

#include "core/input_error.h"
#include "core/sensor/measurement.h"

namespace mapbed {
namespace {

// A list takes up to three times its items while it grows; readings become a log, too.
constexpr std::size_t kWhileGrowing = 3;

std::size_t bytes_of(const IdealReading& reading) {
  const std::size_t itself = kWhileGrowing * (sizeof reading + sizeof(Measurement));
  if (const auto* round = std::get_if<IdealRfid>(&reading)) {
    return itself + round->tags.size() * (sizeof(IdealTag) + sizeof(RfidRead));
  }
  const auto* scan = std::get_if<IdealScan>(&reading);
  if (scan == nullptr) return itself;
  return itself + scan->echoes.size() * sizeof(Echo) +
         scan->first_echo.size() * (sizeof(std::uint32_t) + sizeof(double));
}
std::size_t bytes_of(const StampedStates& states) {
  return kWhileGrowing * sizeof states + states.moving.size() * sizeof(MovingPose);
}
std::size_t bytes_of(const BeamTruthOfScan& scan) {
  return kWhileGrowing * sizeof scan + scan.beams.size() * sizeof(BeamTruth);
}

}  // namespace

RecordingSink sink_into(Recording& recording, std::size_t max_bytes) {
  const auto keep = [used = std::make_shared<std::size_t>(0), max_bytes](auto& list, auto&& item) {
    *used += bytes_of(item);
    if (*used > max_bytes) {
      throw InputError(fmt::format(
          "the recording takes more than {:.3g} GB of memory; choose fewer beams or sub_rays, a "
          "lower scan_rate, fewer people or a smaller recorder.longest",
          static_cast<double>(max_bytes) / 1e9));
    }
    list.push_back(std::move(item));
  };
  return {.reading = [&recording, keep](IdealReading&& r) { keep(recording.readings, r); },
          .states = [&recording, keep](StampedStates&& s) { keep(recording.truth.states, s); },
          .beams = [&recording, keep](BeamTruthOfScan&& b) { keep(recording.truth.beams, b); }};
}

}  // namespace mapbed
