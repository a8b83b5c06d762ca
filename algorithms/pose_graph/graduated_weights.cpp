#include "algorithms/pose_graph/graduated_weights.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace mapbed {
namespace {

constexpr double kFactor = 1.4;  // of the control parameter, as in the paper

}  // namespace

GraduatedWeights::GraduatedWeights(RobustLoss loss, double squared_width,
                                   const std::vector<double>& chi_squares)
    : loss_(loss), squared_width_(squared_width) {
  CHECK(is_graduated(loss));
  const double largest =
      chi_squares.empty() ? 0.0 : *std::max_element(chi_squares.begin(), chi_squares.end());
  // Remark 5: convex where the largest error counts as the least right one.
  mu_ = loss == RobustLoss::graduated_truncated
            ? squared_width / std::max(1e-12, 2.0 * largest - squared_width)
            : std::max(1.0, 2.0 * largest / squared_width);
  is_done_ = largest <= squared_width && loss == RobustLoss::graduated_truncated;
}

// (12) and (14) of the paper.
double GraduatedWeights::weight(double chi_square) const {
  if (loss_ == RobustLoss::graduated_geman_mcclure) {
    const double root = mu_ * squared_width_ / (chi_square + mu_ * squared_width_);
    return root * root;
  }
  if (chi_square >= (mu_ + 1.0) / mu_ * squared_width_) return 0.0;
  if (chi_square <= mu_ / (mu_ + 1.0) * squared_width_) return 1.0;
  return std::sqrt(squared_width_ / chi_square * mu_ * (mu_ + 1.0)) - mu_;
}

std::vector<double> GraduatedWeights::next(const std::vector<double>& chi_squares) {
  std::vector<double> weights;
  weights.reserve(chi_squares.size());
  for (const double chi_square : chi_squares) weights.push_back(weight(chi_square));
  if (loss_ == RobustLoss::graduated_truncated) {
    // Where all weights are 0 or 1 nothing changes any more; above 1e8 the two bounds are one.
    is_done_ = mu_ > 1e8 || std::all_of(weights.begin(), weights.end(), [](double weight) {
                 return weight < 1e-6 || weight > 1.0 - 1e-6;
               });
    mu_ *= kFactor;
  } else {
    is_done_ = mu_ <= 1.0;
    mu_ = std::max(1.0, mu_ / kFactor);
  }
  return weights;
}

}  // namespace mapbed
