#pragma once

#include <functional>
#include <vector>

namespace mapbed {

struct SimplexOptions {
  int max_evaluations = 20'000;
  double tolerance = 1e-9;  // of the function between the simplex's best and worst corner, relative
  int restarts = 3;         // from the best point found, with a fresh simplex
};

// A local minimum of a smooth function of a few parameters without derivatives (Nelder and Mead
// 1965), begun at `start` with steps of `step` along each parameter.
std::vector<double> minimized(const std::function<double(const std::vector<double>&)>& function,
                              std::vector<double> start, const std::vector<double>& step,
                              const SimplexOptions& options = {});

}  // namespace mapbed
