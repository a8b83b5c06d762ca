#pragma once

#include <optional>
#include <vector>

#include "algorithms/input/time_intervals.h"
#include "algorithms/remark.h"
#include "core/config/option.h"
#include "core/log/sensor_log.h"
#include "core/sensor/odometry.h"

namespace mapbed {

struct OdometryCheckOptions {
  double max_speed = 10.0;     // [m/s] no robot goes faster
  double max_turn_rate = 5.0;  // [rad/s]
  double usual_times = 3.0;    // times the log's own fast motions
};

template <class Visitor>
void visit_fields(OdometryCheckOptions& o, Visitor&& visit) {
  visit("max_speed", o.max_speed, Unit::meter_per_second, kPositive,
        "odometry that goes faster has jumped: how the robot moved is not known then");
  visit("max_turn_rate", o.max_turn_rate, Unit::radian_per_second, kPositive,
        "odometry that turns faster has jumped");
  visit("usual_times", o.usual_times, between(1.0, 1e6),
        "and so has odometry that is so many times as fast as the log's own fast motions");
}

// How fast a robot goes by its odometry where it goes fast.
struct UsualMotion {
  double speed = 0.0;      // [m/s]
  double turn_rate = 0.0;  // [rad/s]
};

// Of a whole log; none where that is too short to tell.
std::optional<UsualMotion> usual_motion(const SensorLog& log);

// Counters of wheels may jump, or begin again at zero: after a fault of the wire, a restart of the
// robot's computer, a reset by hand. Odometry goes on then from where it was, as if the robot had
// kept its motion for a moment, or stood where it was still for longer, and is marked.
class OdometryCheck {
 public:
  explicit OdometryCheck(const OdometryCheckOptions& options = {},
                         const std::optional<UsualMotion>& usual = {});

  // The reading as methods should see it; in order of time.
  Odometry checked(Odometry reading);

  // Times in their words are counted from `start` [s].
  std::vector<Remark> remarks(double start) const;

 private:
  bool has_jumped(const Pose2& step, double seconds) const;
  bool has_restarted(const Odometry& reading, const Pose2& step, double seconds) const;
  Pose2 guessed_step(double seconds) const;

  OdometryCheckOptions options_;
  UsualMotion usual_;
  double max_speed_, max_turn_rate_;           // [m/s], [rad/s]
  std::optional<Odometry> first_, last_;       // as they came
  Pose2 passed_;                               // the last one, as it was passed on
  std::optional<Pose2> passed_from_odometry_;  // since the first jump
  double changed_ = 0.0;                       // [s] stamp of the last reading that moved
  Pose2 last_step_;
  double last_seconds_ = 0.0;  // [s] that it took
  TimeIntervals jumps_, restarts_;
  double largest_jump_ = 0.0;  // [m]
};

}  // namespace mapbed
