#pragma once

#include "algorithms/pose_graph/pose_graph.h"

namespace mapbed {

struct CertificateOptions {
  // The largest distance from the global minimum that still is one, as a part of f and of the
  // number of errors that measurements have, which is what f comes to where noise is as told.
  double max_gap = 1e-5;
  // How far information matrices may be from isotropic, as a part, for the graph's own problem to
  // be meant.
  double max_anisotropy = 1e-3;
};

enum class CertifiedProblem : int {
  own,       // information is isotropic: of the graph as it is (in the plane with the chord
             // 2 sin(a/2) of an angle's error a)
  isotropic  // of isotropic_problem.h, which has other optima than the graph
};

struct Certificate {
  CertifiedProblem problem = CertifiedProblem::isotropic;
  // The poses are the global optimum of the problem, but for max_gap. Where false nothing is said:
  // they may be, if noise is so large that the bound is not tight.
  bool certified = false;
  double objective = 0.0;  // f, of isotropic_problem.h, at the poses
  // Of f at any poses, by the dual problem: proven by a Cholesky factorisation, up to its rounding.
  double lower_bound = 0.0;
  double gap = 0.0;  // objective - lower_bound: how far from optimal the poses are at most
  // Of S of rotations, but for those directions that are known to be 0, in which the map as a whole
  // turns. Negative: a direction in which rotations that may stretch, too, do better.
  double min_eigenvalue = 0.0;
  double anisotropy = 0.0;  // of the information matrix that is furthest from isotropic; 0: none is
  // J of the graph at any poses is no less.
  double own_lower_bound = 0.0;

  // Where f is stationary, next to the poses that were given: how far the furthest node has moved.
  double moved = 0.0;       // [m]
  double turned = 0.0;      // [rad]
  bool stationary = false;  // false: no such place was found, and nothing is certified
};

// Whether the poses of a graph are the best that there are, not just the best about them (Carlone,
// Rosen, Calafiore, Leonard, Dellaert 2015; Rosen, Carlone, Bandeira, Leonard 2019), for graphs in
// which nothing is doubted. They are moved to the local minimum of the isotropic problem, where
// S = M - Lambda is made. If S >= -eta in rotations, f >= f(poses) - eta d n anywhere, as
// |R|^2 = d n of n rotations. That S + eta is positive is shown by a factorisation; the least eta
// for which it is, the minimal eigenvalue of S, is found by Lanczos' steps with the inverse.
// A graph of several parts is optimal where each of them is.
template <class Pose>
Certificate certify(const PoseGraph<Pose>& graph, const CertificateOptions& options = {});

}  // namespace mapbed
