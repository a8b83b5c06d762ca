#pragma once

#include "algorithms/motion/motion_prior.h"
#include "core/geometry/pose2.h"

namespace mapbed {

// How much farther the odometry of a robot errs than a MotionSpread says, learned from where scans
// put the robot. A single match says little: where scans are weak it moves only a part of the way
// from the prediction to the truth. Over some metres the moves add up to odometry's error, so that
// their sums are compared with what the spread expects of such a way.
class LearnedSpread {
 public:
  // After a match that was trusted: the motion of odometry in `seconds`, and where the scan put the
  // robot as seen from where that motion ends.
  void add(const Pose2& motion, double seconds, const Pose2& off, const MotionSpread& expected);

  // `options` with the sigmas of odometry as they were learned: never smaller, as odometry that
  // seems better than expected may only be believed too much.
  MotionPriorOptions applied_to(MotionPriorOptions options) const;

 private:
  // Of one axis.
  struct Axis {
    double sum = 0.0;       // of the offsets of the last metres
    double variance = 0.0;  // of that sum, as expected
    double ratio = 1.0;     // of squared sums to variances: its mean over a longer way
    void add(double off, double expected_variance, double way);
  };
  Axis forward_, left_, heading_;
};

}  // namespace mapbed
