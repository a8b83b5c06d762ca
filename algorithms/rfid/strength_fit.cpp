#include "algorithms/rfid/strength_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "algorithms/rfid/robust_fit.h"
#include "core/check.h"

namespace mapbed {
namespace {

// One after the other; which of them are fitted is decided once, by `options`.
class Parameters {
 public:
  Parameters(const StrengthModel& start, const StrengthFitOptions& options)
      : start_(start), options_(options) {
    StrengthModel model = start;
    visit(model, [this](double& value, double low, double high) {
      parameters_.push_back({value, low, high});
    });
  }

  const std::vector<FittedParameter>& all() const { return parameters_; }

  StrengthModel model_of(const std::vector<double>& values) const {
    StrengthModel model = start_;
    std::size_t next = 0;
    visit(model, [&](double& value, double, double) { value = values[next++]; });
    // The tags' mean is in the antennas' levels.
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < model.tags.size(); ++i) sum += model.tags[i];
    model.tags.back() = -sum;
    return model;
  }

 private:
  template <class Visit>
  void visit(StrengthModel& model, const Visit& visit) const {
    for (SpatialAntenna& a : model.antennas) {
      visit(a.level, -200.0, 100.0);
      visit(a.falloff, 0.0, 100.0);
      if (options_.beam) {
        visit(a.azimuth, -10.0 * kPi, 10.0 * kPi);
        visit(a.elevation, -0.5 * kPi, 0.5 * kPi);
        visit(a.beam_width, radians(20.0), radians(360.0));
        visit(a.back, 0.0, 30.0);
      }
      if (options_.position) {
        for (int i = 0; i < 3; ++i) {
          visit(a.position(i), -1.0, 1.0);
        }
      }
    }
    for (std::size_t i = 0; i + 1 < model.tags.size(); ++i) visit(model.tags[i], -40.0, 40.0);
    if (options_.reflector) {
      visit(model.reflector.height, -3.0, 0.5);
      visit(model.reflector.factor, -1.0, 1.0);
    }
    if (options_.threshold) {
      visit(model.threshold.least, -150.0, 0.0);
      visit(model.threshold.sigma, 0.5, 15.0);
    }
  }

  StrengthModel start_;
  StrengthFitOptions options_;
  std::vector<FittedParameter> parameters_;
};

std::vector<double> residuals_of(const StrengthModel& model,
                                 std::span<const StrengthReading> readings) {
  std::vector<double> residuals;
  residuals.reserve(readings.size());
  for (const StrengthReading& reading : readings) {
    residuals.push_back(expected_strength(model, reading.antenna, reading.tag, reading.place) -
                        reading.strength);
  }
  return residuals;
}

StrengthModel improved(const StrengthModel& start, std::span<const StrengthReading> readings,
                       const StrengthFitOptions& options) {
  const Parameters parameters(start, options);
  const auto residuals = [&](const std::vector<double>& values) {
    return residuals_of(parameters.model_of(values), readings);
  };
  return parameters.model_of(robust_fit(residuals, parameters.all(), {.width = options.width}));
}

// Mean strength of an antenna, and the way to where what it reads is stronger than that.
StrengthModel first_guess(std::span<const StrengthReading> readings, int antennas, int tags,
                          bool beam) {
  StrengthModel model;
  model.tags.assign(static_cast<std::size_t>(tags), 0.0);
  for (int antenna = 0; antenna < antennas; ++antenna) {
    double sum = 0.0, count = 0.0;
    for (const StrengthReading& reading : readings) {
      if (reading.antenna != antenna) continue;
      sum += reading.strength;
      count += 1.0;
    }
    CHECK(count > 0.0);
    SpatialAntenna a;
    a.level = sum / count;
    Eigen::Vector3d stronger = Eigen::Vector3d::Zero();
    for (const StrengthReading& reading : readings) {
      if (reading.antenna != antenna) continue;
      stronger += (reading.strength - a.level) * reading.place.normalized();
    }
    a.azimuth = std::atan2(stronger.y(), stronger.x());
    if (!beam) a.back = 0.0;
    if (beam) a.level += 8.0;
    model.antennas.push_back(a);
  }
  return model;
}

// The reflector of least cost, all else as it is: the cost has many minima over the height.
Reflector best_reflector(StrengthModel model, std::span<const StrengthReading> readings,
                         double width) {
  Reflector best = model.reflector;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 170; ++i) {
    for (const double factor : {-0.6, -0.3, 0.3, 0.6}) {
      model.reflector.height = -3.0 + 0.02 * i;
      model.reflector.factor = factor;
      const double cost = robust_cost(residuals_of(model, readings), width);
      if (cost >= least) continue;
      least = cost;
      best = model.reflector;
    }
  }
  return best;
}

}  // namespace

StrengthModel fitted_strength(std::span<const StrengthReading> readings, int antennas, int tags,
                              const StrengthFitOptions& options) {
  StrengthFitOptions some = options;
  some.position = some.reflector = some.threshold = false;
  StrengthModel model =
      improved(first_guess(readings, antennas, tags, options.beam), readings, some);
  if (options.threshold) {
    some.threshold = true;
    model.threshold.sigma = 3.0;
    model = improved(model, readings, some);
  }
  if (options.position) {
    some.position = true;
    model = improved(model, readings, some);
  }
  if (options.reflector) {
    some.reflector = true;
    model.reflector = best_reflector(model, readings, options.width);
    model = improved(model, readings, some);
  }
  for (SpatialAntenna& a : model.antennas) a.azimuth = normalized_angle(a.azimuth);
  return model;
}

}  // namespace mapbed
