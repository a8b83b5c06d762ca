#include "algorithms/localization/known_times.h"

#include <fmt/format.h>

namespace mapbed {

void KnownTimes::add(double time, Unknown why) {
  const bool is_known = why == Unknown::none;
  if (phases_.empty() || phases_.back().is_known() != is_known)
    phases_.push_back({.when = {time, time}});
  Phase& phase = phases_.back();
  phase.when.to = time;
  ++phase.scans[static_cast<std::size_t>(why)];
}

std::vector<TimeInterval> KnownTimes::lost() const {
  std::vector<TimeInterval> result;
  for (const Phase& phase : phases_) {
    if (!phase.is_known()) result.push_back(phase.when);
  }
  return result;
}

std::vector<Remark> KnownTimes::remarks(double start) const {
  std::vector<Remark> result;
  for (std::size_t i = 0; i < phases_.size(); ++i) {
    const Phase& phase = phases_[i];
    if (phase.is_known()) {
      if (i == 0) continue;
      result.push_back(
          {RemarkKind::relocalized,
           fmt::format("the place on the map is known from {:.1f} s on", phase.when.from - start),
           TimeInterval{phase.when.from, phase.when.from}});
      continue;
    }
    const bool nowhere = phase.scans[static_cast<std::size_t>(Unknown::nowhere)] >
                         phase.scans[static_cast<std::size_t>(Unknown::several)];
    result.push_back({RemarkKind::lost,
                      fmt::format("the place on the map is not known from {:.1f} s to {:.1f} s: {}",
                                  phase.when.from - start, phase.when.to - start,
                                  nowhere ? "scans do not fit it where the robot should be"
                                          : "scans fit it in several places"),
                      phase.when});
  }
  return result;
}

}  // namespace mapbed
