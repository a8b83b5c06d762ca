#include "algorithms/scan_matching/matching_diagnostics.h"

namespace mapbed {

// One scan that fits nowhere may have seen people only. After a pause, or with others, it says that
// the robot is elsewhere; so does one after a pause that fits, but not near where it should be.
void MatchingDiagnostics::fits(double time, const ScanMatch& match) {
  const bool elsewhere =
      last_ && time - *last_ > kLongPause && (!match.trustworthy || match.contradicts_prediction);
  if (match.trustworthy) {
    misfits_ = 0;
  } else if (misfits_++ == 0) {
    misfits_since_ = time;
  }
  if (misfits_ == kRun) lost_.tell(misfits_since_, true);
  lost_.tell(time, elsewhere || misfits_ >= kRun);
}

void MatchingDiagnostics::scan(double time, const ScanMatch& match, bool sees,
                               std::optional<double> sigma) {
  if (sees) fits(time, match);
  few_.tell(time, !sees);
  loose_.tell(time, sees && sigma && *sigma > kLoose);
  last_ = time;
}

std::vector<TimeInterval> MatchingDiagnostics::lost() const {
  return lost_.all();
}

std::vector<Remark> MatchingDiagnostics::remarks_on_unknown_motion(double start) const {
  return remarks_on(loose_, RemarkKind::unknown_motion, start,
                    "without odometry, and scans that look alike along the way",
                    ": how far the robot came is not known");
}

std::vector<Remark> MatchingDiagnostics::remarks(double start) const {
  std::vector<Remark> result = remarks_on_unknown_motion(start);
  for (const std::vector<Remark>& more :
       {remarks_on(lost_, RemarkKind::lost, start, "scans do not fit where the robot should be",
                   ": where what was mapped before and after lies to each other is not known"),
        remarks_on(few_, RemarkKind::few_beams, start, "too few beams say something",
                   ": the prediction alone says where the robot is")}) {
    result.insert(result.end(), more.begin(), more.end());
  }
  return result;
}

}  // namespace mapbed
