#include "algorithms/filtered_estimator.h"

#include <utility>

#include "core/check.h"

namespace mapbed {
namespace {

// What both believe of a beam.
std::vector<float> product(std::vector<float> weights, std::span<const float> others) {
  if (weights.empty()) return {others.begin(), others.end()};
  if (others.empty()) return weights;
  CHECK(weights.size() == others.size());
  for (std::size_t beam = 0; beam < weights.size(); ++beam) weights[beam] *= others[beam];
  return weights;
}

}  // namespace

FilteredEstimator::FilteredEstimator(std::unique_ptr<Estimator> method,
                                     std::unique_ptr<BeamFilter> filter)
    : method_(std::move(method)), filter_(std::move(filter)) {
  CHECK(method_ != nullptr && filter_ != nullptr);
}

void FilteredEstimator::add(const Measurement& measurement, std::span<const float> beam_weights) {
  if (const auto* reading = std::get_if<Odometry>(&measurement)) filter_->add(*reading);
  const auto* scan = std::get_if<LaserScan>(&measurement);
  if (scan == nullptr || !lasers_.take(*scan)) {
    method_->add(measurement, beam_weights);
    return;
  }
  std::vector<float> weights = filter_->add(*scan, beam_weights);
  CHECK(weights.empty() || weights.size() == scan->ranges.size());
  method_->add(measurement, product(std::move(weights), beam_weights));
}

Estimate FilteredEstimator::estimate() const {
  Estimate estimate = method_->estimate();
  FilterResult found = filter_->result(estimate.trajectory);
  CHECK(found.labels.size() == estimate.trajectory.size());
  estimate.labels = std::move(found.labels);
  if (found.tracks) estimate.tracks = std::move(found.tracks);
  estimate.remarks.insert(estimate.remarks.end(), found.remarks.begin(), found.remarks.end());
  return estimate;
}

}  // namespace mapbed
