#include "algorithms/pose_graph/robust_loss.h"

#include <cmath>

namespace mapbed {

RobustCost robust_cost(RobustLoss loss, double squared_width, double chi_square) {
  const double c2 = squared_width;
  const double u = chi_square;
  const double fraction = c2 / (c2 + u);
  switch (loss) {
    case RobustLoss::none:
      break;
    case RobustLoss::huber:
      if (u > c2) return {2.0 * std::sqrt(c2 * u) - c2, std::sqrt(c2 / u)};
      break;
    case RobustLoss::cauchy:
      return {c2 * std::log1p(u / c2), fraction};
    case RobustLoss::geman_mcclure:
    case RobustLoss::graduated_geman_mcclure:
      return {fraction * u, fraction * fraction};
    case RobustLoss::switchable:
      if (u > c2) return {fraction * (3.0 * u - c2), 4.0 * fraction * fraction};
      break;
    case RobustLoss::graduated_truncated:
      if (u > c2) return {c2, 0.0};
      break;
  }
  return {u, 1.0};
}

}  // namespace mapbed
