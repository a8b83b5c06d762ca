#pragma once

#include <vector>

#include "algorithms/pose_graph/pose_graph.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

// A graph, and where its nodes truly are.
template <class Pose>
struct KnownGraph {
  PoseGraph<Pose> graph;
  std::vector<Pose> truth;
};

// A drive through the streets of a city of square blocks, as Olson's Manhattan, or in space along
// the edges of a lattice of cubes: a pose at each metre, a turn into any direction but back at each
// crossing, and a loop closed where the robot has been before.
struct LatticeDriveOptions {
  int poses = 1000;
  int block = 5;   // [m] from crossing to crossing
  int blocks = 8;  // of a side
  double loops = 0.3;
  int absence = 20;
  double sigma = 0.05;       // [m] of each coordinate
  double turn_sigma = 0.02;  // [rad] about each axis
};

template <class Visitor>
void visit_fields(LatticeDriveOptions& o, Visitor&& visit) {
  visit("poses", o.poses, between(2, 100'000), "of the drive, 1 m apart");
  visit("block", o.block, between(1, 1000), "metres from crossing to crossing");
  visit("blocks", o.blocks, between(1, 1000), "of a side of the lattice");
  visit("loops", o.loops, between(0.0, 1.0),
        "of the poses where the robot has been before, how many close a loop");
  visit("absence", o.absence, between(1, 1'000'000),
        "poses that lie at least between two of a loop closure");
  visit("sigma", o.sigma, Unit::meter, kPositive,
        "of each coordinate that a constraint measures, odometry and loops alike");
  visit("turn_sigma", o.turn_sigma, Unit::radian, kPositive, "the same about each axis");
}

// The graph's nodes are where odometry alone has them.
template <class Pose>
KnownGraph<Pose> lattice_drive(const LatticeDriveOptions& options, const Rng& rng);

// A measurement of `truth` with an error that has this information.
template <class Pose>
Pose measured(const Pose& truth, const PoseInformation<Pose>& information, Rng& rng);

// The nodes along the constraints that close no loop. Throws InputError where these do not join
// all nodes.
template <class Pose>
std::vector<Pose> odometry_poses(const PoseGraph<Pose>& graph);

}  // namespace mapbed
