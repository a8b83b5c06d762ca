#include "core/geometry/trajectory.h"

#include <algorithm>

namespace mapbed {

std::optional<Pose2> pose_at(const Trajectory& trajectory, double time) {
  if (trajectory.empty() || time < trajectory.front().time || time > trajectory.back().time)
    return {};
  const auto after =
      std::upper_bound(trajectory.begin(), trajectory.end(), time,
                       [](double t, const Stamped<Pose2>& stamped) { return t < stamped.time; });
  if (after == trajectory.end()) return trajectory.back().pose;
  const Stamped<Pose2>& a = *(after - 1);
  const Stamped<Pose2>& b = *after;
  return interpolate(a.pose, b.pose, (time - a.time) / (b.time - a.time));
}

double path_length(const Trajectory& trajectory) {
  double length = 0.0;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    length += distance(trajectory[i - 1].pose, trajectory[i].pose);
  }
  return length;
}

}  // namespace mapbed
