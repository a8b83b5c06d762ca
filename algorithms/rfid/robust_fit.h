#pragma once

#include <functional>
#include <vector>

namespace mapbed {

// A parameter that is fitted, between these ends.
struct FittedParameter {
  double start = 0.0;
  double low = -1e9;
  double high = 1e9;
  double step = 1e-5;  // of the numerical derivative
};

struct RobustFitOptions {
  double width = 4.0;  // residuals beyond it count by their size, not by its square (Huber 1964)
  int max_iterations = 60;
  double tolerance = 1e-8;  // of the cost, relative: a step that gains less is the last one
};

// Parameters of least cost, the sum of Huber's loss over the residuals: Levenberg and Marquardt's
// method with weights by iteration. A local minimum.
std::vector<double> robust_fit(
    const std::function<std::vector<double>(const std::vector<double>&)>& residuals,
    const std::vector<FittedParameter>& parameters, const RobustFitOptions& options = {});

// What is minimised, of residuals.
double robust_cost(const std::vector<double>& residuals, double width);

}  // namespace mapbed
