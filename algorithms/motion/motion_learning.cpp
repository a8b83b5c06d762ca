#include "algorithms/motion/motion_learning.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

#include "core/check.h"
#include "core/data_path.h"
#include "core/input_error.h"
#include "core/statistics/distributions.h"

namespace mapbed {
namespace {

constexpr double kLeastSigma = 1e-4;          // [m] or [rad]
constexpr double kLogTwoPi = 1.837877066409;  // ln(2 pi)

// The sigmas as logarithms.
using Parameters = std::array<double, 6>;

Parameters parameters_of(const MotionModelOptions& m) {
  Parameters p{m.rotation_per_rotation,    m.rotation_per_meter,   m.translation_per_meter,
               m.translation_per_rotation, m.least_rotation_sigma, m.least_translation_sigma};
  for (double& sigma : p) sigma = std::log(std::max(sigma, kLeastSigma));
  return p;
}

MotionModelOptions model_of(const Parameters& p, const MotionModelOptions& biases) {
  return {.rotation_per_rotation = std::exp(p[0]),
          .rotation_per_meter = std::exp(p[1]),
          .translation_per_meter = std::exp(p[2]),
          .translation_per_rotation = std::exp(p[3]),
          .least_rotation_sigma = std::exp(p[4]),
          .least_translation_sigma = std::exp(p[5]),
          .rotation_bias = biases.rotation_bias,
          .translation_bias = biases.translation_bias};
}

bool is_allowed(const Parameters& p) {
  return std::all_of(p.begin(), p.end(), [](double log_sigma) {
    return log_sigma >= std::log(kLeastSigma) && log_sigma <= std::log(2.0);
  });
}

// Of actual = (1 - bias) measured, where the measured one has noise besides. Multiplied by the
// actual one, with which the noise has nothing to do: a regression on the measured one would take
// noise for bias.
double bias_of(double actual_squared, double actual_by_measured) {
  if (actual_by_measured <= 0.0) return 0.0;
  return std::clamp(1.0 - actual_squared / actual_by_measured, -0.5, 0.5);
}

// Of rotations and translations.
MotionModelOptions biases_of(const std::vector<MotionSample>& samples) {
  double rotations = 0.0, rotations_measured = 0.0;
  double translations = 0.0, translations_measured = 0.0;
  for (const MotionSample& sample : samples) {
    const double translation = parts_of(sample.reference).translation;
    rotations += sample.reference.theta * sample.reference.theta;
    rotations_measured += sample.reference.theta * sample.measured.theta;
    translations += translation * translation;
    translations_measured += translation * parts_of(sample.measured).translation;
  }
  return {.rotation_bias = bias_of(rotations, rotations_measured),
          .translation_bias = bias_of(translations, translations_measured)};
}

Eigen::Vector3d vector_of(const Pose2& pose) {
  return {pose.x, pose.y, pose.theta};
}

// e^T P e of a sample.
double squared_error(const MotionSample& sample, const PosePrior& prior) {
  const Eigen::Vector3d error = vector_of(motion_between(prior.mean, sample.reference));
  return error.dot(prior.information * error);
}

std::string path_of_model(const std::string& name_or_path) {
  return find_data_file("motion model", "algorithms/motion/motion_models", name_or_path).string();
}

Settings settings_of_model(const std::string& name_or_path) {
  return load_settings(path_of_model(name_or_path));
}

// The same, but a wrong name is told with its place.
Settings model_settings_named_by(const Setting& setting) {
  try {
    return settings_of_model(setting.text);
  } catch (const InputError& error) {
    if (setting.place.file.empty()) throw;
    throw InputError(setting.place, error.what());
  }
}

// `odometry_errors: pioneer_odometry`
bool names_model(const Setting& setting) {
  const bool is_model = setting.path == "odometry_errors" || setting.path == "matching_errors";
  return is_model && !setting.text.empty() && setting.text.front() != '{';
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
  const MotionModelOptions biases = biases_of(samples);
  Parameters best = parameters_of(start);
  double best_value = mean_log_likelihood(samples, model_of(best, biases));
  // A sigma changes by a factor of e^step.
  for (double step = 1.0; step >= 0.01;) {
    const double before = best_value;
    for (std::size_t i = 0; i < best.size(); ++i) {
      for (const double side : {-1.0, 1.0}) {
        Parameters tried = best;
        tried[i] += side * step;
        if (!is_allowed(tried)) continue;
        const double value = mean_log_likelihood(samples, model_of(tried, biases));
        if (value <= best_value) continue;
        best = tried;
        best_value = value;
      }
    }
    if (best_value - before < 1e-7) step /= 2;
  }
  return model_of(best, biases);
}

Calibration calibration_of(const std::vector<MotionSample>& samples,
                           const MotionModelOptions& model) {
  CHECK(!samples.empty());
  const double quantile_95 = chi_square_quantile(0.95, 3);
  double sum = 0.0;
  int within = 0;
  for (const MotionSample& sample : samples) {
    const double squared = squared_error(sample, gaussian_after({}, sample.measured, model));
    sum += squared / 3.0;
    within += squared <= quantile_95 ? 1 : 0;
  }
  const auto count = static_cast<double>(samples.size());
  return {sum / count, within / count};
}

double autocorrelation_of(const std::vector<MotionSample>& samples,
                          const MotionModelOptions& model) {
  CHECK(samples.size() >= 2);
  double squares = 0.0, products = 0.0;
  Eigen::Vector3d before = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const PosePrior prior = gaussian_after({}, samples[i].measured, model);
    const Eigen::Vector3d error = vector_of(motion_between(prior.mean, samples[i].reference));
    // P = L L^T: the components of L^T e are independent and of unit variance.
    const Eigen::Vector3d whitened = prior.information.llt().matrixU() * error;
    if (i > 0) {
      products += whitened.dot(before);
      squares += 0.5 * (whitened.squaredNorm() + before.squaredNorm());
    }
    before = whitened;
  }
  return squares > 0.0 ? products / squares : 0.0;
}

MotionModelOptions load_motion_model(const std::string& name_or_path) {
  MotionModelOptions model;
  apply(settings_of_model(name_or_path), options_of(model), "motion model");
  return model;
}

InputFile motion_model_file(const std::string& name_or_path) {
  return input_file(path_of_model(name_or_path));
}

InputFiles learned_model_files(const Settings& settings) {
  InputFiles files;
  for (const Setting& setting : settings) {
    if (names_model(setting)) files.push_back(motion_model_file(setting.text));
  }
  return files;
}

Settings with_learned_models(const Settings& settings) {
  Settings result;
  for (const Setting& setting : settings) {
    if (!names_model(setting)) {
      result.push_back(setting);
      continue;
    }
    for (Setting parameter : model_settings_named_by(setting)) {
      parameter.path = setting.path + "." + parameter.path;
      result.push_back(std::move(parameter));
    }
  }
  return result;
}

}  // namespace mapbed
