#include "algorithms/rfid/robust_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace mapbed {
namespace {

Eigen::Map<const Eigen::VectorXd> vector_of(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

// Normal equations at `at`, each residual with the weight that makes its square Huber's loss.
struct Linearized {
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
};

Linearized linearized(
    const std::function<std::vector<double>(const std::vector<double>&)>& residuals,
    const std::vector<FittedParameter>& parameters, const std::vector<double>& at,
    const std::vector<double>& here, double width) {
  Eigen::MatrixXd jacobian(static_cast<Eigen::Index>(here.size()),
                           static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    std::vector<double> moved = at;
    // Inwards, where the parameter is at its upper end.
    const double step =
        at[i] + parameters[i].step > parameters[i].high ? -parameters[i].step : parameters[i].step;
    moved[i] += step;
    jacobian.col(static_cast<Eigen::Index>(i)) =
        (vector_of(residuals(moved)) - vector_of(here)) / step;
  }
  Eigen::VectorXd weights(jacobian.rows());
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    const double size = std::abs(here[static_cast<std::size_t>(i)]);
    weights(i) = size <= width ? 1.0 : width / size;
  }
  const Eigen::MatrixXd weighted = weights.asDiagonal() * jacobian;
  return {jacobian.transpose() * weighted, weighted.transpose() * vector_of(here)};
}

}  // namespace

double robust_cost(const std::vector<double>& residuals, double width) {
  double sum = 0.0;
  for (const double residual : residuals) {
    const double size = std::abs(residual);
    sum += size <= width ? 0.5 * size * size : width * (size - 0.5 * width);
  }
  return sum;
}

std::vector<double> robust_fit(
    const std::function<std::vector<double>(const std::vector<double>&)>& residuals,
    const std::vector<FittedParameter>& parameters, const RobustFitOptions& options) {
  std::vector<double> at;
  for (const FittedParameter& parameter : parameters) at.push_back(parameter.start);
  std::vector<double> here = residuals(at);
  double cost = robust_cost(here, options.width);
  double damping = 1e-3;
  for (int iteration = 0; iteration < options.max_iterations; ++iteration) {
    const Linearized system = linearized(residuals, parameters, at, here, options.width);
    double gained = 0.0;
    while (gained <= 0.0 && damping < 1e9) {
      Eigen::MatrixXd damped = system.information;
      damped.diagonal() += damping * system.information.diagonal();
      damped.diagonal().array() += 1e-9;
      const Eigen::VectorXd step = damped.ldlt().solve(system.gradient);
      std::vector<double> next = at;
      for (std::size_t i = 0; i < next.size(); ++i) {
        next[i] = std::clamp(at[i] - step(static_cast<Eigen::Index>(i)), parameters[i].low,
                             parameters[i].high);
      }
      std::vector<double> there = residuals(next);
      const double cost_there = robust_cost(there, options.width);
      if (cost_there < cost) {
        gained = cost - cost_there;
        at = std::move(next);
        here = std::move(there);
        cost = cost_there;
        damping = std::max(1e-9, 0.2 * damping);
      } else {
        damping *= 5.0;
      }
    }
    if (gained <= options.tolerance * cost) break;
  }
  return at;
}

}  // namespace mapbed
