#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/pose2.h"
#include "core/geometry/pose3.h"

namespace mapbed {

// Degrees of freedom of a pose: the size of a step on its tangent.
template <class Pose>
inline constexpr int kDegreesOfFreedom = 0;
template <>
inline constexpr int kDegreesOfFreedom<Pose2> = 3;
template <>
inline constexpr int kDegreesOfFreedom<Pose3> = 6;

template <class Pose>
using PoseTangent = Eigen::Matrix<double, kDegreesOfFreedom<Pose>, 1>;
template <class Pose>
using PoseInformation = Eigen::Matrix<double, kDegreesOfFreedom<Pose>, kDegreesOfFreedom<Pose>>;

// A measurement of where one node of a graph lies in the frame of another, (6.4). Its error is that
// of g2o: of inverse(from_from_to) * inverse(map_from_from) * map_from_to, in the plane
// (x, y, theta), in space (x, y, z) and the vector part of the rotation's quaternion with w >= 0,
// which is the sine of half the angle.
template <class Pose>
struct PoseConstraint {
  int from = 0, to = 0;  // indices of nodes
  Pose from_from_to;
  PoseInformation<Pose> information = PoseInformation<Pose>::Identity();
  // Of two places that were taken for one, so that it may be wrong altogether: robust kernels and
  // switches apply to these alone. Odometry is never doubted.
  bool closes_loop = false;
};

// Poses that are known by measurements of where they lie to each other.
template <class Pose>
struct PoseGraph {
  std::vector<Pose> nodes;  // map_from_node, as they are believed now
  std::vector<PoseConstraint<Pose>> constraints;
  // Nodes that keep their pose. In a component of the graph that has none, its first node does.
  std::vector<int> held = {};
};

// The number of the component that each node is in, from 0 in the order of their first nodes.
template <class Pose>
std::vector<int> components_of(const PoseGraph<Pose>& graph);
std::vector<int> components_of(int nodes, const std::vector<std::pair<int, int>>& joined);

// For each node whether it keeps its pose.
template <class Pose>
std::vector<bool> held_nodes(const PoseGraph<Pose>& graph);

}  // namespace mapbed
