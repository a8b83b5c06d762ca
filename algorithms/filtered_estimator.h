#pragma once

#include <memory>

#include "algorithms/beam_filter.h"
#include "algorithms/estimator.h"
#include "algorithms/scan/level_lasers.h"

namespace mapbed {

// Any method behind a filter of beams, section 3.3: the filter sees each scan first and says how
// far its beams may be believed, (3.11); in the end it labels all of them.
class FilteredEstimator : public Estimator {
 public:
  FilteredEstimator(std::unique_ptr<Estimator> method, std::unique_ptr<BeamFilter> filter);

  void add(const Measurement& measurement, std::span<const float> beam_weights = {}) override;
  void finish() override { method_->finish(); }
  Pose2 pose() const override { return method_->pose(); }
  Estimate estimate() const override;
  Trajectory path_so_far() const override { return method_->path_so_far(); }
  Hypotheses hypotheses() const override { return method_->hypotheses(); }

 private:
  std::unique_ptr<Estimator> method_;
  std::unique_ptr<BeamFilter> filter_;
  LevelLasers lasers_;
};

}  // namespace mapbed
