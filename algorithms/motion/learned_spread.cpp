#include "algorithms/motion/learned_spread.h"

#include <algorithm>
#include <cmath>

namespace mapbed {
namespace {

constexpr double kSumWay = 2.0;        // [m] over which offsets are added up
constexpr double kLearningWay = 20.0;  // [m] over which the ratio is learned
constexpr double kLargest = 9.0;  // ratio that one sum may tell: beyond three sigma wheels slip

}  // namespace

void LearnedSpread::Axis::add(double off, double expected_variance, double way) {
  const double kept = std::exp(-way / kSumWay);
  sum = kept * sum + off;
  variance = kept * kept * variance + expected_variance;
  const double told = std::min(sum * sum / variance, kLargest);
  ratio += (1.0 - std::exp(-way / kLearningWay)) * (told - ratio);
}

void LearnedSpread::add(const Pose2& motion, double seconds, const Pose2& off,
                        const MotionSpread& expected) {
  const double way = std::hypot(motion.x, motion.y);
  const MotionVariance variance = variance_after(motion, seconds, expected);
  forward_.add(off.x, variance.position, way);
  left_.add(off.y, variance.position, way);
  heading_.add(off.theta, variance.heading, way);
}

MotionPriorOptions LearnedSpread::applied_to(MotionPriorOptions options) const {
  const double position = std::sqrt(std::max({1.0, forward_.ratio, left_.ratio}));
  const double heading = std::sqrt(std::max(1.0, heading_.ratio));
  options.odometry.position_per_meter *= position;
  options.odometry.position_per_turn *= position;
  options.odometry.position_per_time *= position;
  for (MotionSpread* spread : {&options.odometry, &options.slip}) {
    spread->heading_per_meter *= heading;
    spread->heading_per_turn *= heading;
    spread->heading_per_time *= heading;
  }
  return options;
}

}  // namespace mapbed
