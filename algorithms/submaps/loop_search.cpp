#include "algorithms/submaps/loop_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/submaps/reach.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

// [m] between the scans of two local maps that are nearest to each other.
double nearest_scans(const Submap& a, const Submap& b, const Pose2& a_from_b) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Pose2& in_b : b.path) {
    const Eigen::Vector2d place = a_from_b * in_b.position();
    for (const Pose2& in_a : a.path) {
      nearest = std::min(nearest, (in_a.position() - place).norm());
    }
  }
  return nearest;
}

}  // namespace

std::vector<LoopCandidate> loop_candidates(const SubmapNodes& submaps, int query,
                                           const PoseGraph<Pose2>& graph,
                                           const std::vector<double>& weights,
                                           const LoopSearchOptions& options) {
  const auto node_of = [&](int submap) { return submaps.nodes[static_cast<std::size_t>(submap)]; };
  const auto pose_of = [&](int submap) {
    return graph.nodes[static_cast<std::size_t>(node_of(submap))];
  };
  const std::vector<Reach> reach = reach_of(graph, weights, node_of(query));
  struct Ranked {
    double rank = 0.0;  // [m] that nobody knows, and what two scans are apart
    LoopCandidate candidate;
  };
  std::vector<Ranked> ranked;
  const Submap& of_query = submaps.submaps[static_cast<std::size_t>(query)];
  for (int target = 0; target < static_cast<int>(submaps.submaps.size()); ++target) {
    if (std::abs(target - query) <= options.apart) continue;
    const Reach& seen = reach[static_cast<std::size_t>(node_of(target))];
    const double sigma = seen.reached
                             ? std::sqrt(std::max(seen.covariance(0, 0), seen.covariance(1, 1)))
                             : options.largest_window;
    const double turn_sigma = seen.reached ? std::sqrt(seen.covariance(2, 2)) : kPi;
    const double unknown = options.sigmas * sigma;
    const Pose2 target_from_query = motion_between(pose_of(target), pose_of(query));
    const double apart = nearest_scans(submaps.submaps[static_cast<std::size_t>(target)], of_query,
                                       target_from_query);
    if (apart > options.distance + unknown) continue;
    ranked.push_back({apart + sigma,
                      {target, target_from_query,
                       std::clamp(unknown, options.least_window, options.largest_window),
                       std::clamp(options.sigmas * turn_sigma, options.least_turn_window, kPi)}});
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const Ranked& a, const Ranked& b) { return a.rank < b.rank; });
  std::vector<LoopCandidate> candidates;
  for (const Ranked& next : ranked) {
    if (static_cast<int>(candidates.size()) >= options.candidates) break;
    const bool stands_apart =
        std::none_of(candidates.begin(), candidates.end(), [&](const LoopCandidate& chosen) {
          return std::abs(chosen.target - next.candidate.target) <= 1;
        });
    if (stands_apart) candidates.push_back(next.candidate);
  }
  return candidates;
}

}  // namespace mapbed
