#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "algorithms/remark.h"
#include "core/time_interval.h"

namespace mapbed {

// When something held, told measurement by measurement.
class TimeIntervals {
 public:
  void tell(double time, bool holds);
  const std::vector<TimeInterval>& all() const { return all_; }

  // Those that do not begin at a time of which `left_out` is true.
  template <class Predicate>
  TimeIntervals without(Predicate&& left_out) const {
    TimeIntervals rest;
    std::copy_if(all_.begin(), all_.end(), std::back_inserter(rest.all_),
                 [&](const TimeInterval& interval) { return !left_out(interval.from); });
    return rest;
  }

 private:
  std::vector<TimeInterval> all_;
  bool holds_ = false;
};

// "no odometry from 12.3 s to 22.4 s after the start: …", for the first three; more are summed up.
std::vector<Remark> remarks_on(const TimeIntervals& intervals, RemarkKind kind, double start,
                               const std::string& what, const std::string& then);

}  // namespace mapbed
