#pragma once

#include "algorithms/estimator.h"

namespace mapbed {

struct OdometryOptions {
  double longest_gap = 1.0;  // [s] without odometry beside a scan before that is remarked on
};

template <class Visitor>
void visit_fields(OdometryOptions& o, Visitor&& visit) {
  visit("longest_gap", o.longest_gap, Unit::second, kPositive,
        "without odometry beside a scan, before that is remarked on");
}

// The baseline: dead reckoning alone. The map frame is the robot's frame at the first scan. A scan
// between two readings lies linearly between them; before the first and after the last one the
// robot is taken to stand, and such a scan counts as untrusted.
class OdometryEstimator : public Estimator {
 public:
  explicit OdometryEstimator(const OdometryOptions& options = {}) : options_(options) {}

  void add(const Measurement& measurement) override;
  Pose2 pose() const override;
  Estimate estimate() const override;

 private:
  OdometryOptions options_;
  Trajectory odometry_;              // odometry_from_robot
  std::vector<double> scan_stamps_;  // [s]
};

}  // namespace mapbed
