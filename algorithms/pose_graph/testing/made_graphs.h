#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "algorithms/pose_graph/pose_graph.h"
#include "core/geometry/angle.h"
#include "core/random.h"

namespace mapbed {

inline Pose2 random_pose2(Rng& rng, double spread = 1.0) {
  return {rng.normal(0.0, spread), rng.normal(0.0, spread), rng.uniform(-kPi, kPi)};
}

inline Pose3 random_pose3(Rng& rng, double spread = 1.0) {
  Eigen::Quaterniond q;
  q.coeffs() << rng.normal(0.0, 1.0), rng.normal(0.0, 1.0), rng.normal(0.0, 1.0),
      rng.normal(0.0, 1.0);
  return {{rng.normal(0.0, spread), rng.normal(0.0, spread), rng.normal(0.0, spread)},
          q.normalized()};
}

template <class Pose>
Pose random_pose(Rng& rng, double spread = 1.0) {
  if constexpr (kDegreesOfFreedom<Pose> == 3)
    return random_pose2(rng, spread);
  else
    return random_pose3(rng, spread);
}

// Positive definite, with eigenvalues of about 10.
template <class Pose>
PoseInformation<Pose> random_information(Rng& rng) {
  PoseInformation<Pose> root;
  for (double& entry : root.reshaped()) entry = rng.normal(0.0, 1.0);
  const PoseInformation<Pose> square = root * root.transpose();
  return 5.0 * PoseInformation<Pose>::Identity() + 0.5 * (square + square.transpose());
}

// Chords of a ring of nodes, of what is true: a chain, and every `stride`-th node to the one
// `reach` further on.
template <class Pose>
PoseGraph<Pose> ring_without_noise(Rng& rng, int count, int stride = 3, int reach = 7) {
  PoseGraph<Pose> graph;
  for (int i = 0; i < count; ++i) graph.nodes.push_back(random_pose<Pose>(rng, 5.0));
  const auto add = [&](int from, int to) {
    graph.constraints.push_back({from, to,
                                 motion_between(graph.nodes[static_cast<std::size_t>(from)],
                                                graph.nodes[static_cast<std::size_t>(to)]),
                                 random_information<Pose>(rng), to - from != 1});
  };
  for (int i = 0; i + 1 < count; ++i) add(i, i + 1);
  for (int i = 0; i < count; i += stride) {
    if ((i + reach) % count != i) add(i, (i + reach) % count);
  }
  return graph;
}

}  // namespace mapbed
