#pragma once

#include <optional>
#include <vector>

#include "algorithms/input/time_intervals.h"
#include "algorithms/remark.h"
#include "algorithms/scan_matching/scan_matcher.h"

namespace mapbed {

// Collects what the user should know of how scans were matched: where they fitted nowhere, said too
// little, or told only a part of the motion while nothing else told the rest.
class MatchingDiagnostics {
 public:
  // In order of time; all but the first scan. `sees`: it has enough hits to be matched. `sigma`: of
  // the position as the scan alone tells it, in the worst direction [m], where no odometry does.
  void scan(double time, const ScanMatch& match, bool sees, std::optional<double> sigma);

  std::vector<TimeInterval> lost() const;  // the poses then do not lie right to those before
  // Times in their words are counted from `start` [s].
  std::vector<Remark> remarks(double start) const;
  std::vector<Remark> remarks_on_unknown_motion(double start) const;

 private:
  static constexpr double kLongPause = 5.0;  // [s] between scans: the robot may be anywhere
  static constexpr int kRun = 3;             // scans that fit nowhere, one after the other
  static constexpr double kLoose = 0.2;      // [m]

  void fits(double time, const ScanMatch& match);

  std::optional<double> last_;  // [s] stamp of the newest scan
  int misfits_ = 0;             // newest scans, one after the other
  double misfits_since_ = 0.0;  // [s]
  TimeIntervals lost_, few_, loose_;
};

}  // namespace mapbed
