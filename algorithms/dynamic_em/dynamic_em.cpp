#include "algorithms/dynamic_em/dynamic_em.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "algorithms/scan/beam_weights.h"
#include "core/check.h"

namespace mapbed {
namespace {

// (4.11). What is rather dynamic is left out, so that it enters no local map either; a beam that
// met nothing says what it says.
std::vector<float> weights_of(const ScanLabels& labels, std::span<const float> told) {
  std::vector<float> weights(labels.static_probability.size(), 1.0F);
  for (std::size_t n = 0; n < weights.size(); ++n) {
    const float e = labels.static_probability[n];
    if (!std::isnan(e)) weights[n] = is_dynamic(e) ? 0.0F : e;
    if (!told.empty()) weights[n] *= told[n];
  }
  return weights;
}

bool improves(double likelihood, double before, double fraction) {
  return likelihood - before > fraction * std::abs(before);
}

Remark remark_on_end(int iterations, bool has_settled) {
  if (has_settled) {
    return {RemarkKind::note, fmt::format("EM: settled after {} iterations", iterations)};
  }
  return {RemarkKind::note,
          fmt::format("EM: ended after {} iterations, as many as it may have, while the likelihood "
                      "still grew; raise em.iterations",
                      iterations)};
}

}  // namespace

DynamicEm::DynamicEm(const DynamicEmOptions& options, MakeMethod make_method)
    : options_(options), make_method_(std::move(make_method)), method_(make_method_()) {
  CHECK(method_ != nullptr);
}

void DynamicEm::add(const Measurement& measurement, std::span<const float> beam_weights) {
  CHECK(!found_);
  method_->add(measurement, beam_weights);
  const auto* scan = std::get_if<LaserScan>(&measurement);
  const bool has_told = scan != nullptr && !beam_weights.empty();
  log_.push_back(has_told ? with_failed_beams(*scan, beam_weights) : measurement);
  told_.emplace_back(beam_weights.begin(), beam_weights.end());
}

// All scans through a new method, weighed by their labels.
Estimate DynamicEm::registered(const BeamLabels& labels) const {
  const std::unique_ptr<Estimator> method = make_method_();
  auto next = labels.begin();
  for (std::size_t i = 0; i < log_.size(); ++i) {
    const auto* scan = std::get_if<LaserScan>(&log_[i]);
    if (scan == nullptr || !scan->robot_from_laser.is_level()) {
      method->add(log_[i], told_[i]);
    } else {
      CHECK(next != labels.end());
      method->add(log_[i], weights_of(*next++, told_[i]));
    }
  }
  method->finish();
  return method->estimate();
}

void DynamicEm::finish() {
  method_->finish();
  Estimate path = method_->estimate();
  if (path.trajectory.empty()) return;
  const CauseMapOptions of_map{
      .p_static = options_.p_static, .resolution = options_.resolution, .beams = options_.beams};
  IterationValues expected{"log_likelihood", Unit::none, {}};
  IterationValues marginal{"marginal_log_likelihood", Unit::none, {}};
  std::optional<CauseMap> map;  // of the newest path
  double best = -HUGE_VAL;
  bool has_settled = false;
  for (int i = 0; i < options_.iterations && !has_settled; ++i) {
    if (i > 0 && options_.register_again) path = registered(*found_->labels);
    if (i == 0 || options_.register_again) map.emplace(log_, path.trajectory, of_map);
    if (i == 0) {
      expected.values.push_back(map->expected_log_likelihood());
      marginal.values.push_back(map->marginal_log_likelihood());
    }
    for (int k = 0; k < options_.map_steps; ++k) map->step();
    expected.values.push_back(map->expected_log_likelihood());
    marginal.values.push_back(map->marginal_log_likelihood());
    has_settled = i > 0 && !improves(marginal.values.back(), best, options_.improvement);
    if (marginal.values.back() <= best) continue;
    best = marginal.values.back();
    found_ = path;
    found_->labels = map->labels(log_, path.trajectory);
  }
  const int iterations = static_cast<int>(marginal.values.size()) - 1;
  found_->remarks.push_back(remark_on_end(iterations, has_settled));
  found_->iterations = {std::move(expected), std::move(marginal)};
}

Estimate DynamicEm::estimate() const {
  return found_ ? *found_ : method_->estimate();
}

}  // namespace mapbed
