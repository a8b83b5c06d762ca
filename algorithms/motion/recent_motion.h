#pragma once

#include <deque>
#include <vector>

#include "algorithms/motion/motion_prior.h"
#include "core/geometry/pose2.h"

namespace mapbed {

// Where the robot was during the last seconds by scans and by odometry. Odometry that stands still
// for a while and then tells the whole way at once is right about all of it together, and wrong
// about its last step: scans have followed the robot meanwhile.
class RecentMotion {
 public:
  explicit RecentMotion(const MotionPriorOptions& options) : options_(options) {}

  void add(double time, const Pose2& map_from_robot, const Pose2& odometry_from_robot);
  void clear() { past_.clear(); }

  // Where odometry has the robot now, starting from where scans had it some time ago, where that is
  // elsewhere than its last step ends: once for each such place, the newest past first.
  // Empty: scans and odometry agree about the last seconds.
  std::vector<PosePrior> elsewhere(double time, const Pose2& odometry_from_robot) const;

 private:
  struct Past {
    double time = 0.0;  // [s]
    Pose2 map_from_robot;
    Pose2 odometry_from_robot;
  };
  MotionPriorOptions options_;
  std::deque<Past> past_;  // oldest first
};

}  // namespace mapbed
