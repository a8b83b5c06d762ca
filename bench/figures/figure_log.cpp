#include "bench/figures/figure_log.h"

#include <utility>

#include "bench/sources/run_input.h"
#include "core/interrupted.h"
#include "sim/recording.h"

namespace mapbed {

FigureLog figure_log_of(const RunInput& prepared) {
  FigureLog log{prepared.log, prepared.truth, {}};
  if (prepared.recording == nullptr) return log;
  for (ReplayTrack& other : replay_of(prepared.recording->truth, {}).others) {
    if (other.kind == "person") log.people.push_back(std::move(other));
  }
  return log;
}

void LogTaker::begins(const RunInput& prepared, const std::string& /*method*/) {
  taken_.emplace(figure_log_of(prepared));
  throw Interrupted();
}

}  // namespace mapbed
