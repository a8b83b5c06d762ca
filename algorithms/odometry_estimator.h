#pragma once

#include "algorithms/estimator.h"
#include "algorithms/scan/level_lasers.h"
#include "core/config/option.h"

namespace mapbed {

struct OdometryOptions {
  double longest_gap = 1.0;  // [s] without odometry beside a scan before that is remarked on
};

template <class Visitor>
void visit_fields(OdometryOptions& o, Visitor&& visit) {
  visit("longest_gap", o.longest_gap, Unit::second, kPositive,
        "without odometry beside a scan, before that is remarked on");
}

// The baseline: dead reckoning alone, from `start`, map_from_robot at the first scan. A scan
// between two readings lies linearly between them; before the first and after the last one the
// robot is taken to stand, and such a scan counts as untrusted.
class OdometryEstimator : public Estimator {
 public:
  explicit OdometryEstimator(const OdometryOptions& options = {}, const Pose2& start = {})
      : options_(options), start_(start) {}

  void add(const Measurement& measurement, std::span<const float> beam_weights = {}) override;
  Pose2 pose() const override;
  Estimate estimate() const override;

 private:
  OdometryOptions options_;
  Pose2 start_;
  LevelLasers lasers_;
  Trajectory odometry_;              // odometry_from_robot
  std::vector<double> scan_stamps_;  // [s]
};

}  // namespace mapbed
