#include "algorithms/rbpf/motion_learning.h"

#include <array>
#include <cmath>

#include <Eigen/Dense>

#include "core/check.h"
#include "core/config/settings.h"
#include "core/data_path.h"

namespace mapbed {
namespace {

constexpr double kLeastSpread = 1e-4;         // [m] or [rad]
constexpr double kInside95 = 7.814727903;     // chi-squared with 3 degrees of freedom
constexpr double kLogTwoPi = 1.837877066409;  // ln(2 pi)

// Six spreads as logarithms, two biases.
using Parameters = std::array<double, 8>;

Parameters parameters_of(const MotionModelOptions& m) {
  Parameters p{m.turn_noise, m.turn_per_meter, m.way_per_meter, m.way_per_turn,
               m.floor_turn, m.floor_way,      m.turn_bias,     m.way_bias};
  for (std::size_t i = 0; i < 6; ++i) p[i] = std::log(std::max(p[i], kLeastSpread));
  return p;
}

MotionModelOptions model_of(const Parameters& p) {
  return {.turn_noise = std::exp(p[0]),
          .turn_per_meter = std::exp(p[1]),
          .way_per_meter = std::exp(p[2]),
          .way_per_turn = std::exp(p[3]),
          .floor_turn = std::exp(p[4]),
          .floor_way = std::exp(p[5]),
          .turn_bias = p[6],
          .way_bias = p[7]};
}

bool is_allowed(const Parameters& p) {
  for (std::size_t i = 0; i < 6; ++i) {
    if (p[i] < std::log(kLeastSpread) || p[i] > std::log(2.0)) return false;
  }
  return std::abs(p[6]) < 0.5 && std::abs(p[7]) < 0.5;
}

Eigen::Vector3d vector_of(const Pose2& pose) {
  return {pose.x, pose.y, pose.theta};
}

// e^T P e of a sample.
double squared_error(const MotionSample& sample, const PosePrior& prior) {
  const Eigen::Vector3d error = vector_of(motion_between(prior.mean, sample.reference));
  return error.dot(prior.information * error);
}

}  // namespace

double mean_log_likelihood(const std::vector<MotionSample>& samples,
                           const MotionModelOptions& model) {
  CHECK(!samples.empty());
  double sum = 0.0;
  for (const MotionSample& sample : samples) {
    const PosePrior prior = gaussian_after({}, sample.measured, model);
    sum += 0.5 * std::log(prior.information.determinant()) - 1.5 * kLogTwoPi -
           0.5 * squared_error(sample, prior);
  }
  return sum / static_cast<double>(samples.size());
}

MotionModelOptions learned_motion_model(const std::vector<MotionSample>& samples,
                                        const MotionModelOptions& start) {
  Parameters best = parameters_of(start);
  double best_value = mean_log_likelihood(samples, model_of(best));
  // Spreads change by a factor of e^step, biases by a twentieth of the step.
  for (double step = 1.0; step >= 0.01;) {
    const double before = best_value;
    for (std::size_t i = 0; i < best.size(); ++i) {
      for (const double side : {-1.0, 1.0}) {
        Parameters tried = best;
        tried[i] += side * (i < 6 ? step : 0.05 * step);
        if (!is_allowed(tried)) continue;
        const double value = mean_log_likelihood(samples, model_of(tried));
        if (value <= best_value) continue;
        best = tried;
        best_value = value;
      }
    }
    if (best_value - before < 1e-7) step /= 2;
  }
  return model_of(best);
}

Calibration calibration_of(const std::vector<MotionSample>& samples,
                           const MotionModelOptions& model) {
  CHECK(!samples.empty());
  double sum = 0.0;
  int inside = 0;
  for (const MotionSample& sample : samples) {
    const double squared = squared_error(sample, gaussian_after({}, sample.measured, model));
    sum += squared / 3.0;
    inside += squared <= kInside95 ? 1 : 0;
  }
  const auto count = static_cast<double>(samples.size());
  return {sum / count, inside / count};
}

MotionModelOptions load_motion_model(const std::string& name_or_path) {
  const std::string path =
      find_data_file("motion model", "algorithms/rbpf/motion_models", name_or_path).string();
  MotionModelOptions model;
  apply(load_settings(path), options_of(model), "motion model");
  return model;
}

}  // namespace mapbed
