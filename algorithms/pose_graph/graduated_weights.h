#pragma once

#include <vector>

#include "algorithms/pose_graph/robust_loss.h"

namespace mapbed {

// Graduated non-convexity (Yang, Antonante, Tzoumas, Carlone 2020): weights of constraints, in turn
// with the minimum at these weights, while the loss goes from a convex function to its own form.
class GraduatedWeights {
 public:
  // `squared_width`: chi-square of what is still right. `chi_squares` at the minimum of all with
  // weight 1, of the constraints that may be wrong.
  GraduatedWeights(RobustLoss loss, double squared_width, const std::vector<double>& chi_squares);

  bool is_done() const { return is_done_; }
  // The next weights; the loss comes a step nearer to its form.
  std::vector<double> next(const std::vector<double>& chi_squares);

 private:
  double weight(double chi_square) const;

  RobustLoss loss_;
  double squared_width_;
  double mu_;  // the paper's control parameter
  bool is_done_;
};

}  // namespace mapbed
