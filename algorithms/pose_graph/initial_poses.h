#pragma once

#include <vector>

#include "algorithms/pose_graph/pose_graph.h"

namespace mapbed {

// Where an optimisation may begin without poses, or from none of those that the graph has. Nodes
// that held_nodes() names keep their poses.

// Poses along the constraints of a tree, each node by as few of them as can be.
template <class Pose>
std::vector<Pose> spanning_tree_poses(const PoseGraph<Pose>& graph);

// Rotations as the nearest ones to the matrices that minimise sum w |R_to - R_from R_from_to|^2,
// which is linear; then positions, which are linear given the rotations (Martinec, Pajdla 2007;
// Carlone et al. 2015). Mostly in the basin of the global optimum. Where the equations are
// singular: spanning_tree_poses().
template <class Pose>
std::vector<Pose> chordal_poses(const PoseGraph<Pose>& graph);

}  // namespace mapbed
