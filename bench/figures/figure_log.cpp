#include "bench/figures/figure_log.h"

#include <utility>

#include "bench/sources/run_input.h"
#include "core/interrupted.h"
#include "sim/recording.h"

namespace mapbed {

void LogTaker::begins(const RunInput& prepared, const std::string& /*method*/) {
  taken_.emplace(FigureLog{prepared.log, prepared.truth, {}});
  if (prepared.recording != nullptr) {
    for (ReplayTrack& other : replay_of(prepared.recording->truth, {}).others) {
      if (other.kind == "person") taken_->people.push_back(std::move(other));
    }
  }
  throw Interrupted();
}

}  // namespace mapbed
