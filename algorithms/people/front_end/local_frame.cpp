#include "algorithms/people/front_end/local_frame.h"

namespace mapbed {

void LocalFrame::add(const Odometry& reading) {
  odometry_.add(reading);
  matcher_.add(reading);
}

Pose2 LocalFrame::predicted(double time) const {
  const Pose2 last = matcher_.pose();
  if (!last_time_) return last;
  const std::optional<Pose2> odometry = odometry_.at(time);
  if (odometry && odometry_at_last_scan_) {
    return last * motion_between(*odometry_at_last_scan_, *odometry);
  }
  const double seconds = time - *last_time_;
  const bool goes_on = last_seconds_ > 0.0 && seconds > 0.0 && seconds < 2.0 * last_seconds_;
  return goes_on ? last * interpolate({}, last_motion_, seconds / last_seconds_) : last;
}

Pose2 LocalFrame::add(const LaserScan& scan, std::span<const float> beam_weights) {
  const Pose2 before = matcher_.pose();
  matcher_.add(scan, beam_weights);
  if (last_time_) {
    last_motion_ = motion_between(before, matcher_.pose());
    last_seconds_ = scan.time - *last_time_;
  }
  last_time_ = scan.time;
  odometry_at_last_scan_ = odometry_.at(scan.time);
  return matcher_.pose();
}

}  // namespace mapbed
