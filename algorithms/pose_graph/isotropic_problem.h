#pragma once

#include <vector>

#include "algorithms/pose_graph/pose_graph.h"
#include "algorithms/pose_graph/sparse_factor.h"

namespace mapbed {

// Of a pose's position: 2 or 3.
template <class Pose>
inline constexpr int kDimension = kDegreesOfFreedom<Pose> == 3 ? 2 : 3;

// The pose graph problem of SE-Sync (Rosen, Carlone, Bandeira, Leonard 2019), which the dual of a
// semidefinite program bounds from below: with T = (R t) of every node, d x (d + 1), and E of every
// measurement, homogeneous,
//
//   f(T) = sum (kappa |R_j - R_i R_ij|^2 + tau |t_j - t_i - R_i t_ij|^2)
//        = sum |(T_i E_ij - T_j) diag(kappa, .., kappa, tau)^(1/2)|^2 = tr(T M T').
//
// kappa and tau are those of SE-Sync, by traces of covariances: tau = d / tr(Sigma_t); in space
// kappa = 3 / (2 tr(Sigma_r)) with Sigma_r that of the rotation vector, which is four times that of
// the quaternion's vector part (SE-Sync's reader takes g2o's numbers for the rotation vector's,
// which makes kappa four times as large); in the plane 1 / (2 sigma^2), as a rotation by angle a is
// |R - I|^2 = 8 sin^2(a/2) away (SE-Sync's reader: 1 / sigma^2). So f is the graph's own J, (6.6)
// doubled, where information matrices are isotropic: exactly so in space; in the plane up to the
// chord 2 sin(a/2) in place of the angle, so that f <= J.
template <class Pose>
struct IsotropicProblem {
  static constexpr int kBlock = kDimension<Pose> + 1;

  int nodes = 0;
  std::vector<NodeBlock<kBlock>> blocks;  // of M
  // e' information e >= least_part e' isotropic e for the errors e of all constraints, most_part
  // above: both 1 where information is isotropic. J >= least_part f.
  double least_part = 1.0, most_part = 1.0;
};

struct IsotropicWeights {
  double kappa = 0.0, tau = 0.0;
};

template <class Pose>
IsotropicWeights isotropic_weights(const PoseInformation<Pose>& information);

// Of all constraints, none of them doubted. What has no positive definite
// information of position, or of rotation, says nothing of it.
template <class Pose>
IsotropicProblem<Pose> isotropic_problem(const PoseGraph<Pose>& graph);

template <class Pose>
struct StationaryPoint {
  std::vector<Pose> poses;
  double objective = 0.0;  // f
  // S = M - Lambda: Lambda of T'T = I at the poses, in the rotations' blocks. 2 S is the Hessian
  // along rotations, and T S = 0 where f is stationary.
  std::vector<NodeBlock<IsotropicProblem<Pose>::kBlock>> hessian;
  int iterations = 0;
  bool converged = false;
};

// The local minimum of f about the poses, by Newton's steps on the manifold, damped where the
// Hessian is not positive definite or f would not fall.
template <class Pose>
StationaryPoint<Pose> polish(const PoseGraph<Pose>& graph, const IsotropicProblem<Pose>& problem);

}  // namespace mapbed
