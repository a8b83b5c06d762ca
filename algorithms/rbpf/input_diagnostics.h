#pragma once

#include <optional>
#include <vector>

#include "algorithms/input/time_intervals.h"
#include "algorithms/remark.h"
#include "core/config/option.h"
#include "core/sensor/odometry.h"
#include "core/time_interval.h"

namespace mapbed {

// When a filter says that its input or itself failed.
struct InputDiagnosticsOptions {
  double max_pause = 5.0;   // [s] between scans, where the robot did not just stand still
  double standing = 1.5;    // [m], [rad] up to which it did
  double lost_below = 0.2;  // of an update's scan that the best particle's map explains
};

template <class Visitor>
void visit_fields(InputDiagnosticsOptions& o, Visitor&& visit) {
  visit("max_pause", o.max_pause, Unit::second, kPositive, "longer ones between scans are told");
  visit("lost_below", o.lost_below, kFraction,
        "fraction of an update's scan that the best map explains where the robot is lost, at most");
}

// Collects what the user should know of a run. Lost is a robot that sees next to nothing of what
// the best particle's map holds: also where it drives into the unknown, a part of each scan still
// lies on what it has just seen. Soon after, the new place is on the map too and explains its
// scans; but how it lies to the old one is not known, unless the robot is found in the map of
// before.
class InputDiagnostics {
 public:
  // Where scans are not matched, a robot without odometry is taken to stand still.
  explicit InputDiagnostics(const InputDiagnosticsOptions& options, bool scans_are_matched = true)
      : options_(options), scans_are_matched_(scans_are_matched) {}

  void odometry(const Odometry& reading);
  // `step` by odometry since the scan before, if there is any. `fits`: it lies on what was seen
  // just before, near where odometry has the robot.
  void scan(double time, const std::optional<Pose2>& step, bool sees_anything, bool fits = true);
  // Of a scan that sees: how much of it the best particle's map explains, and whether the robot may
  // be there by its map of before an interruption.
  void update(double time, double inlier_ratio, bool possible = true);
  bool loses(double inlier_ratio) const { return inlier_ratio < options_.lost_below; }

  // [s] of something after which the robot may be anywhere, since the last update: motion
  // that odometry does not know, or a pause or a laser that saw nothing without odometry to bridge
  // it, or a pause after which the scan does not fit, as of a robot that was carried away.
  std::optional<double> interruption() const { return interruption_; }
  // Where the map of before `since` shows the robot at `time`.
  void relocalized(double since, double time) { relocalized_.push_back({since, time}); }

  std::vector<TimeInterval> lost() const;  // and not found again
  std::vector<Remark> remarks() const;     // their words tell times from the first measurement on

 private:
  TimeIntervals lost_for_good() const;  // the robot was not found again

  InputDiagnosticsOptions options_;
  bool scans_are_matched_;
  double start_ = 0.0;
  bool started_ = false;
  std::optional<double> last_scan_;     // [s] of the newest one
  std::optional<double> interruption_;  // [s]
  struct Relocalized {
    double since = 0.0, time = 0.0;  // [s]
  };
  std::vector<Relocalized> relocalized_;
  TimeIntervals no_odometry_, blind_, neither_, pauses_, lost_;
};

}  // namespace mapbed
