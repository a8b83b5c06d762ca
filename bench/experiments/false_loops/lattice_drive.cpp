#include "bench/experiments/false_loops/lattice_drive.h"

#include <array>
#include <cmath>
#include <map>

#include <Eigen/Cholesky>

#include "algorithms/pose_graph/constraint_error.h"
#include "algorithms/pose_graph/initial_poses.h"
#include "core/geometry/angle.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

using LatticePoint = std::array<long, 3>;

LatticePoint lattice_point(const Pose2& pose) {
  return {std::lround(pose.x), std::lround(pose.y), 0};
}
LatticePoint lattice_point(const Pose3& pose) {
  return {std::lround(pose.position.x()), std::lround(pose.position.y()),
          std::lround(pose.position.z())};
}

// Straight on, and to all sides.
template <class Pose>
std::vector<Pose> turns() {
  constexpr double kSides[] = {-kPi / 2.0, kPi / 2.0};
  std::vector<Pose> result{Pose{}};
  for (const double turn : kSides) {
    if constexpr (kDegreesOfFreedom<Pose> == 3) {
      result.push_back({0.0, 0.0, turn});
    } else {
      result.push_back({Eigen::Vector3d::Zero(), rotation_of(turn, 0.0, 0.0)});
      result.push_back({Eigen::Vector3d::Zero(), rotation_of(0.0, turn, 0.0)});
    }
  }
  return result;
}

template <class Pose>
Pose ahead(double way) {
  Pose pose;
  if constexpr (kDegreesOfFreedom<Pose> == 3) {
    pose.x = way;
  } else {
    pose.position.x() = way;
  }
  return pose;
}

template <class Pose>
std::vector<Pose> true_poses(const LatticeDriveOptions& options, Rng rng) {
  const long side = static_cast<long>(options.block) * options.blocks;
  const auto is_inside = [side](const Pose& pose) {
    for (const long at : lattice_point(pose)) {
      if (at < 0 || at > side) return false;
    }
    return true;
  };
  std::vector<Pose> poses{Pose{}};
  Pose turn;
  for (int i = 1; i < options.poses; ++i) {
    turn = Pose{};
    if ((i - 1) % options.block == 0) {
      std::vector<Pose> open;
      for (const Pose& way : turns<Pose>()) {
        if (is_inside(poses.back() * way * ahead<Pose>(options.block))) open.push_back(way);
      }
      turn = open[rng.index(open.size())];
    }
    poses.push_back(poses.back() * turn * ahead<Pose>(1.0));
  }
  return poses;
}

// In space of the vector part of the rotation's quaternion, half the angle.
template <class Pose>
PoseInformation<Pose> information_of(const LatticeDriveOptions& options) {
  PoseTangent<Pose> sigmas;
  if constexpr (kDegreesOfFreedom<Pose> == 3) {
    sigmas << options.sigma, options.sigma, options.turn_sigma;
  } else {
    sigmas << Eigen::Vector3d::Constant(options.sigma),
        Eigen::Vector3d::Constant(options.turn_sigma / 2.0);
  }
  return sigmas.cwiseAbs2().cwiseInverse().asDiagonal();
}

}  // namespace

template <class Pose>
Pose measured(const Pose& truth, const PoseInformation<Pose>& information, Rng& rng) {
  PoseTangent<Pose> error;
  for (double& entry : error) entry = rng.normal();
  // With information = L L', L'^-1 times a standard normal vector has its inverse as covariance.
  error = information.llt().matrixU().solve(error).eval();
  if constexpr (kDegreesOfFreedom<Pose> == 6) error.template tail<3>() *= 2.0;
  return truth * moved(Pose{}, error);
}

template <class Pose>
std::vector<Pose> odometry_poses(const PoseGraph<Pose>& graph) {
  PoseGraph<Pose> odometry{.nodes = graph.nodes, .held = graph.held};
  for (const PoseConstraint<Pose>& constraint : graph.constraints) {
    if (!constraint.closes_loop) odometry.constraints.push_back(constraint);
  }
  for (const int component : components_of(odometry)) {
    if (component > 0) {
      throw InputError({}, "odometry does not join all nodes of the graph",
                       "take one in which each id and the next have a constraint");
    }
  }
  return spanning_tree_poses(odometry);
}

template <class Pose>
KnownGraph<Pose> lattice_drive(const LatticeDriveOptions& options, const Rng& rng) {
  KnownGraph<Pose> known{.truth = true_poses<Pose>(options, rng.stream("turns"))};
  Rng chance = rng.stream("loops");
  Rng noise = rng.stream("noise");
  const PoseInformation<Pose> information = information_of<Pose>(options);
  const auto measure = [&](int from, int to, bool closes_loop) {
    const Pose motion = motion_between(known.truth[static_cast<std::size_t>(from)],
                                       known.truth[static_cast<std::size_t>(to)]);
    known.graph.constraints.push_back(
        {from, to, measured(motion, information, noise), information, closes_loop});
  };
  for (int i = 1; i < options.poses; ++i) measure(i - 1, i, false);

  std::map<LatticePoint, std::vector<int>> visits;
  for (int i = 0; i < options.poses; ++i) {
    std::vector<int>& here = visits[lattice_point(known.truth[static_cast<std::size_t>(i)])];
    std::size_t earlier = 0;
    while (earlier < here.size() && here[earlier] <= i - options.absence) ++earlier;
    if (earlier > 0 && chance.uniform() < options.loops) {
      measure(here[chance.index(earlier)], i, true);
    }
    here.push_back(i);
  }
  known.graph.nodes.resize(known.truth.size());
  known.graph.nodes = odometry_poses(known.graph);
  return known;
}

template KnownGraph<Pose2> lattice_drive(const LatticeDriveOptions&, const Rng&);
template KnownGraph<Pose3> lattice_drive(const LatticeDriveOptions&, const Rng&);
template Pose2 measured(const Pose2&, const PoseInformation<Pose2>&, Rng&);
template Pose3 measured(const Pose3&, const PoseInformation<Pose3>&, Rng&);
template std::vector<Pose2> odometry_poses(const PoseGraph<Pose2>&);
template std::vector<Pose3> odometry_poses(const PoseGraph<Pose3>&);

}  // namespace mapbed
