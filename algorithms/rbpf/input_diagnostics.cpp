#include "algorithms/rbpf/input_diagnostics.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace mapbed {
namespace {

constexpr std::size_t kTold = 3;        // intervals of one kind; more are summed up
constexpr double kLeastSeconds = 0.25;  // between readings: stamps may be that far off

}  // namespace

void TimeIntervals::tell(double time, bool holds) {
  if (holds && !holds_) all_.push_back({time, time});
  if (holds) all_.back().to = time;
  holds_ = holds;
}

TimeIntervals TimeIntervals::without(const std::function<bool(double)>& left_out) const {
  TimeIntervals rest;
  std::copy_if(all_.begin(), all_.end(), std::back_inserter(rest.all_),
               [&](const TimeInterval& interval) { return !left_out(interval.from); });
  return rest;
}

Odometry InputDiagnostics::without_jumps(const Odometry& odometry) {
  if (!started_) start_ = odometry.time;
  started_ = true;
  if (!last_) {
    passed_ = odometry.odometry_from_robot;
  } else {
    const Pose2 step = motion_between(last_->odometry_from_robot, odometry.odometry_from_robot);
    const double seconds = std::max(kLeastSeconds, odometry.time - last_->time);
    const double translation = std::hypot(step.x, step.y);
    const bool jumped = translation > options_.max_speed * seconds ||
                        std::abs(step.theta) > options_.max_turn_rate * seconds;
    if (jumped) largest_jump_ = std::max(largest_jump_, translation);
    jumps_.tell(odometry.time, jumped);
    if (jumped) interruption_ = odometry.time;
    if (!jumped) passed_ = passed_ * step;
  }
  last_ = odometry;
  Odometry passed = odometry;
  passed.odometry_from_robot = passed_;
  return passed;
}

void InputDiagnostics::scan(double time, const std::optional<Pose2>& step, bool sees_anything) {
  if (!started_) start_ = time;
  started_ = true;
  const bool moves_unmeasured = last_scan_ && !step;  // the first scan has no step to be measured
  no_odometry_.tell(time, moves_unmeasured && sees_anything);
  blind_.tell(time, !moves_unmeasured && !sees_anything);
  neither_.tell(time, moves_unmeasured && !sees_anything);
  if (!sees_anything && !step) interruption_ = time;
  const bool stood = step && std::hypot(step->x, step->y) <= options_.standing &&
                     std::abs(step->theta) <= options_.standing;
  if (last_scan_ && time - *last_scan_ > options_.max_pause && !stood) {
    pauses_.tell(*last_scan_, true);
    pauses_.tell(time, true);
    pauses_.tell(time, false);
    if (!step) interruption_ = time;
  }
  last_scan_ = time;
}

void InputDiagnostics::update(double time, double inlier_ratio, bool possible) {
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
    const std::vector<TimeInterval>& all = intervals.all();
    for (std::size_t i = 0; i < std::min(kTold, all.size()); ++i) {
      result.push_back({kind,
                        fmt::format("{} from {:.1f} s to {:.1f} s after the start{}", what,
                                    all[i].from - start_, all[i].to - start_, then),
                        all[i]});
    }
    if (all.size() <= kTold) return;
    result.push_back({kind, fmt::format("{}: {} times in all", what, all.size()),
                      TimeInterval{all[kTold].from, all.back().to}});
  };
  tell(RemarkKind::no_odometry, no_odometry_, "no odometry",
       scans_are_matched_ ? ": scans alone say how the robot moves"
                          : ": taken as standing still, as scans are not matched with proposal "
                            "'odometry'");
  tell(RemarkKind::odometry_jump, jumps_, "odometry jumps",
       fmt::format(" (by up to {:.1f} m): taken as standing still", largest_jump_));
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
