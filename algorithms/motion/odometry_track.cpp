#include "algorithms/motion/odometry_track.h"

namespace mapbed {

void OdometryTrack::add(const Odometry& odometry) {
  // Of readings with one stamp the later one counts.
  if (!newest_ || odometry.time > newest_->time) before_ = newest_;
  newest_ = odometry;
}

std::optional<Pose2> OdometryTrack::at(double time) const {
  if (!newest_ || time > newest_->time + kMaxAge) return {};
  const Pose2& newest = newest_->odometry_from_robot;
  if (!before_ || newest_->time == time) return newest;
  const double step = newest_->time - before_->time;
  if (step > kMaxAge && time > newest_->time) return newest;
  return interpolate(before_->odometry_from_robot, newest, (time - before_->time) / step);
}

}  // namespace mapbed
