#pragma once

#include <vector>

#include <Eigen/Core>

#include "algorithms/pose_graph/pose_graph.h"

namespace mapbed {

// The covariance of an error in the frame of b, as an error of the same motion in that of a.
Eigen::Matrix3d seen_from(const Eigen::Matrix3d& in_b, const Pose2& a_from_b);

// How well a node's pose is known as seen from another.
struct Reach {
  bool reached = false;  // by constraints
  // Of (x, y, theta) of the node as seen from the other one, in the frame of that one.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

// Of a node as seen from each of the others (and itself): the uncertainties of constraints added
// along the path that is surest in the whole, Dijkstra projection (Bosse et al. 2004). It is never
// too sure, as that of all paths together is smaller, and takes a time of n log n. Constraints of
// no weight are no paths.
std::vector<Reach> reach_of(const PoseGraph<Pose2>& graph, const std::vector<double>& weights,
                            int node);

}  // namespace mapbed
