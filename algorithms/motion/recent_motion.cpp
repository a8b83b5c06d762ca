#include "algorithms/motion/recent_motion.h"

#include <algorithm>
#include <cmath>

namespace mapbed {
namespace {

constexpr double kLongest = 5.0;  // [s] that odometry may stand still and catch up

// Whether a pose lies farther from a prediction than in 4 of 5 cases of even slipping wheels: chi
// square of 3 degrees of freedom.
bool is_elsewhere(const PosePrior& prediction, const Pose2& pose) {
  const Pose2 off = motion_between(prediction.mean, pose);
  const Eigen::Vector3d e(off.x, off.y, off.theta);
  return e.dot(prediction.tail * e) > 4.64;
}

// Near enough that a search about one finds the other.
bool is_beside(const Pose2& a, const Pose2& b) {
  constexpr double kBeside = 0.3;  // [m], [rad]
  const Pose2 off = motion_between(a, b);
  return std::hypot(off.x, off.y) < kBeside && std::abs(off.theta) < kBeside;
}

}  // namespace

void RecentMotion::add(double time, const Pose2& map_from_robot, const Pose2& odometry_from_robot) {
  past_.push_back({time, map_from_robot, odometry_from_robot});
  while (time - past_.front().time > kLongest) past_.pop_front();
}

std::vector<PosePrior> RecentMotion::elsewhere(double time,
                                               const Pose2& odometry_from_robot) const {
  std::vector<PosePrior> result;
  if (past_.size() < 2) return result;
  const auto predicted = [&](const Past& past) {
    return predict(past.map_from_robot,
                   motion_between(past.odometry_from_robot, odometry_from_robot), time - past.time,
                   options_);
  };
  const Pose2 step = predicted(past_.back()).mean;
  for (auto past = past_.rbegin() + 1; past != past_.rend(); ++past) {
    const PosePrior prediction = predicted(*past);
    const bool is_new = is_elsewhere(prediction, step) &&
                        std::all_of(result.begin(), result.end(), [&](const PosePrior& other) {
                          return !is_beside(prediction.mean, other.mean);
                        });
    if (is_new) result.push_back(prediction);
  }
  return result;
}

}  // namespace mapbed
