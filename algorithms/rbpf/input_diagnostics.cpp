#include "algorithms/rbpf/input_diagnostics.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mapbed {

void InputDiagnostics::odometry(const Odometry& reading) {
  if (!started_) start_ = reading.time;
  started_ = true;
  if (reading.motion_unknown) interruption_ = reading.time;
}

void InputDiagnostics::scan(double time, const std::optional<Pose2>& step, bool sees_anything,
                            bool fits) {
  if (!started_) start_ = time;
  started_ = true;
  const bool moves_unmeasured = last_scan_ && !step;  // the first scan has no step to be measured
  no_odometry_.tell(time, moves_unmeasured && sees_anything);
  blind_.tell(time, !moves_unmeasured && !sees_anything);
  neither_.tell(time, moves_unmeasured && !sees_anything);
  if (!sees_anything && !step) interruption_ = time;
  const bool stood = step && std::hypot(step->x, step->y) <= options_.standing &&
                     std::abs(step->theta) <= options_.standing;
  const bool after_pause = last_scan_ && time - *last_scan_ > options_.max_pause;
  if (after_pause && sees_anything && !fits) interruption_ = time;
  if (after_pause && !stood) {
    pauses_.tell(*last_scan_, true);
    pauses_.tell(time, true);
    pauses_.tell(time, false);
    if (!step) interruption_ = time;
  }
  last_scan_ = time;
}

void InputDiagnostics::update(double time, double inlier_ratio, bool possible) {
  if (interruption_ && !possible) lost_.tell(*interruption_, true);
  lost_.tell(time, loses(inlier_ratio) || !possible);
  interruption_.reset();
}

TimeIntervals InputDiagnostics::lost_for_good() const {
  const auto was_found = [&](double time) {
    return std::any_of(relocalized_.begin(), relocalized_.end(), [&](const Relocalized& found) {
      return found.since <= time && time <= found.time;
    });
  };
  return lost_.without(was_found);
}

std::vector<TimeInterval> InputDiagnostics::lost() const {
  return lost_for_good().all();
}

std::vector<Remark> InputDiagnostics::remarks() const {
  std::vector<Remark> result;
  const auto tell = [&](RemarkKind kind, const TimeIntervals& intervals, const std::string& what,
                        const std::string& then) {
    for (Remark& remark : remarks_on(intervals, kind, start_, what, then)) {
      result.push_back(std::move(remark));
    }
  };
  tell(RemarkKind::no_odometry, no_odometry_, "no odometry",
       scans_are_matched_ ? ": scans alone say how the robot moves"
                          : ": taken as standing still, as scans are not matched with proposal "
                            "'odometry'");
  tell(RemarkKind::no_scan, pauses_, "no scan", "");
  tell(RemarkKind::blind_laser, blind_, "the laser sees nothing",
       ": odometry alone says where the robot is");
  tell(RemarkKind::unknown_motion, neither_, "neither odometry nor anything that the laser sees",
       ": how the robot moved is not known");
  for (const Relocalized& found : relocalized_) {
    result.push_back({RemarkKind::relocalized,
                      fmt::format("lost at {:.1f} s, found again at {:.1f} s after the start, by "
                                  "its map of before",
                                  found.since - start_, found.time - start_),
                      TimeInterval{found.since, found.time}});
  }
  tell(RemarkKind::lost, lost_for_good(), "lost",
       ": the map explains too little of the scans; where what was mapped before and after lies to "
       "each other is not known");
  return result;
}

}  // namespace mapbed
