#pragma once

#include "core/config/option.h"

namespace mapbed {

// What a constraint that closes a loop costs, as a function of its chi-square u; c is the width:
//   none                        u
//   huber                       u up to c^2, then 2 c sqrt(u) - c^2
//   cauchy                      c^2 ln(1 + u / c^2)
//   geman_mcclure               c^2 u / (c^2 + u)
//   switchable                  u up to c^2, then c^2 (3 u - c^2) / (u + c^2): switchable
//   constraints
//                               whose switch is always at its optimum, which is dynamic covariance
//                               scaling (Agarwal et al. 2013) with Phi = c^2
//   graduated_truncated         min(u, c^2), and
//   graduated_geman_mcclure     geman_mcclure, both by graduated non-convexity (Yang et al. 2020):
//                               from a convex function step by step to this one, c^2 the quantile
//                               `inlier_probability` of the chi-square distribution
enum class RobustLoss : int {
  none,
  huber,
  cauchy,
  geman_mcclure,
  switchable,
  graduated_truncated,
  graduated_geman_mcclure
};

struct RobustLossOptions {
  RobustLoss loss = RobustLoss::none;
  double width = 1.0;  // [sigma] c
  double inlier_probability = 0.99;
};

template <class Visitor>
void visit_fields(RobustLossOptions& o, Visitor&& visit) {
  visit("loss", o.loss,
        {"none", "huber", "cauchy", "geman_mcclure", "switchable", "graduated_truncated",
         "graduated_geman_mcclure"},
        "what a constraint that closes a loop costs the more it is off");
  visit("width", o.width, between(1e-3, 1e6),
        "errors above this many sigma count less; of the losses that are not graduated");
  visit("inlier_probability", o.inlier_probability, between(0.5, 1.0 - 1e-9),
        "of right constraints that graduated losses let through");
}

constexpr bool is_graduated(RobustLoss loss) {
  return loss == RobustLoss::graduated_truncated || loss == RobustLoss::graduated_geman_mcclure;
}

// The cost of a constraint, and by how much a small change of its chi-square changes it.
struct RobustCost {
  double cost = 0.0;
  double weight = 1.0;
};

RobustCost robust_cost(RobustLoss loss, double squared_width, double chi_square);

}  // namespace mapbed
