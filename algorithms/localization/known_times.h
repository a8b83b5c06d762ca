#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "algorithms/remark.h"
#include "core/time_interval.h"

namespace mapbed {

// Why a robot's place on a map counts as not known.
enum class Unknown : int {
  none,     // it is known
  several,  // scans fit in several places, or anywhere along one
  nowhere,  // they do not fit the map where the robot should be
};

// When it was known, from scan to scan.
class KnownTimes {
 public:
  void add(double time, Unknown why);

  std::vector<TimeInterval> lost() const;
  // When it was not known, and why; when it was known again. Times from `start` [s] on.
  std::vector<Remark> remarks(double start) const;

 private:
  struct Phase {
    TimeInterval when;
    std::array<int, 3> scans{};  // by why
    bool is_known() const { return scans[0] > 0; }
  };
  std::vector<Phase> phases_;  // known and not, in turn
};

}  // namespace mapbed
