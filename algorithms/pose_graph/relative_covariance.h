#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "algorithms/pose_graph/pose_graph.h"

namespace mapbed {

// How well a graph knows where its nodes lie to each other, by its equations linearised at its
// poses and factorised once: for gates of loop candidates.
template <class Pose>
class RelativeCovariances {
 public:
  // `weights` of the constraints, as optimize() leaves them; none: all 1.
  explicit RelativeCovariances(const PoseGraph<Pose>& graph,
                               const std::vector<double>& weights = {});
  ~RelativeCovariances();
  RelativeCovariances(const RelativeCovariances&) = delete;
  RelativeCovariances& operator=(const RelativeCovariances&) = delete;

  // Of inverse(map_from_a) * map_from_b: position in a's frame; heading, in space the rotation
  // vector in b's frame [rad]. J inverse(H) J', by one pass through the factor for each degree of
  // freedom. Nothing where the graph does not fix it: in different components.
  std::optional<PoseInformation<Pose>> between(int a, int b) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mapbed
