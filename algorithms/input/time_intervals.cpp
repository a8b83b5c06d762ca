#include "algorithms/input/time_intervals.h"

#include <fmt/format.h>

namespace mapbed {

void TimeIntervals::tell(double time, bool holds) {
  if (holds && !holds_) all_.push_back({time, time});
  if (holds) all_.back().to = time;
  holds_ = holds;
}

std::vector<Remark> remarks_on(const TimeIntervals& intervals, RemarkKind kind, double start,
                               const std::string& what, const std::string& then) {
  constexpr std::size_t kTold = 3;
  const std::vector<TimeInterval>& all = intervals.all();
  std::vector<Remark> remarks;
  for (std::size_t i = 0; i < std::min(kTold, all.size()); ++i) {
    remarks.push_back({kind,
                       fmt::format("{} from {:.1f} s to {:.1f} s after the start{}", what,
                                   all[i].from - start, all[i].to - start, then),
                       all[i]});
  }
  if (all.size() > kTold) {
    remarks.push_back({kind, fmt::format("{}: {} times in all", what, all.size()),
                       TimeInterval{all[kTold].from, all.back().to}});
  }
  return remarks;
}

}  // namespace mapbed
