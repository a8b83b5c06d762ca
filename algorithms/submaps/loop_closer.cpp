#include "algorithms/submaps/loop_closer.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include <Eigen/Dense>
#include <tbb/parallel_for.h>

#include "algorithms/submaps/reach.h"
#include "core/geometry/angle.h"
#include "core/statistics/distributions.h"

namespace mapbed {

LoopCloser::LoopCloser(SubmapFields fields, const LoopCloserOptions& options)
    : options_(options), fields_(std::move(fields)) {}

void LoopCloser::add(Submap submap, int node) {
  submaps_.push_back(std::move(submap));
  nodes_.push_back(node);
}

std::vector<LoopMatch> LoopCloser::matches_of(int query,
                                              const std::vector<LoopCandidate>& candidates) {
  const Submap& of_query = submaps_[static_cast<std::size_t>(query)];
  std::vector<LoopCandidate> fresh;
  std::vector<std::shared_ptr<const SubmapField>> fields;
  for (const LoopCandidate& candidate : candidates) {
    if (!searched_.emplace(candidate.target, query).second) continue;
    fresh.push_back(candidate);
    fields.push_back(
        fields_.of(submaps_[static_cast<std::size_t>(candidate.target)], candidate.target));
  }
  if (fresh.empty()) return {};
  const std::shared_ptr<const SubmapField> query_field = fields_.of(of_query, query);
  std::vector<std::optional<SubmapMatch>> found(fresh.size());
  tbb::parallel_for(std::size_t{0}, fresh.size(), [&](std::size_t i) {
    const LoopCandidate& candidate = fresh[i];
    found[i] = match_submaps(submaps_[static_cast<std::size_t>(candidate.target)], *fields[i],
                             of_query, *query_field, candidate.target_from_query, candidate.window,
                             candidate.turn_window, options_.matching);
  });
  std::vector<LoopMatch> matches;
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    if (!found[i] || !found[i]->is_unique) continue;
    matches.push_back({fresh[i].target, query, found[i]->target_from_query, found[i]->covariance,
                       fresh[i].window, fresh[i].turn_window});
  }
  return matches;
}

std::vector<LoopMatch> LoopCloser::find(int query, const PoseGraph<Pose2>& graph,
                                        const std::vector<double>& weights) {
  const std::vector<LoopCandidate> candidates =
      loop_candidates({submaps_, nodes_}, query, graph, weights, options_.search);
  const std::vector<LoopMatch> matches = matches_of(query, candidates);
  std::vector<LoopMatch> believed;
  for (const LoopMatch& match : matches) {
    double chance = match.window <= options_.sure_window ? 0.0 : 1.0;
    std::vector<std::size_t> agreeing;
    for (std::size_t other = 0; other < waiting_.size(); ++other) {
      const std::optional<double> of_both =
          chance_of_agreement(match, waiting_[other], graph, weights);
      if (!of_both) continue;
      chance *= *of_both;
      agreeing.push_back(other);
    }
    if (chance > options_.confirming_chance) {
      waiting_.push_back(match);
      continue;
    }
    for (const std::size_t other : agreeing) believed.push_back(waiting_[other]);
    for (auto other = agreeing.rbegin(); other != agreeing.rend(); ++other) {
      waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(*other));
    }
    believed.push_back(match);
  }
  return believed;
}

// None where the two do not have the query of `a` at the same place of its target.
std::optional<double> LoopCloser::chance_of_agreement(const LoopMatch& a, const LoopMatch& b,
                                                      const PoseGraph<Pose2>& graph,
                                                      const std::vector<double>& weights) const {
  if (a.query == b.query || std::abs(a.query - b.query) > options_.confirmed_within) return {};
  const auto pose_of = [&](int submap) {
    return graph.nodes[static_cast<std::size_t>(node_of(submap))];
  };
  const auto reach_between = [&](int from, int to) {
    return reach_of(graph, weights, node_of(to))[static_cast<std::size_t>(node_of(from))];
  };
  const Reach targets = reach_between(a.target, b.target);
  const Reach queries = reach_between(b.query, a.query);
  if (!targets.reached || !queries.reached) return {};
  // a.target <- b.target <- b.query <- a.query
  const Pose2 b_query_from_a_query = motion_between(pose_of(b.query), pose_of(a.query));
  const Pose2 by_b = motion_between(pose_of(a.target), pose_of(b.target)) * b.target_from_query *
                     b_query_from_a_query;
  const Pose2 error = motion_between(a.target_from_query, by_b);
  // To first order all errors as those of a position and a heading, turned into one frame.
  const auto turned = [](const Eigen::Matrix3d& covariance, double angle, double lever) {
    Eigen::Matrix3d moves = Eigen::Matrix3d::Identity();
    const double c = std::cos(angle), s = std::sin(angle);
    moves.topLeftCorner<2, 2>() << c, -s, s, c;
    Eigen::Matrix3d result = moves * covariance * moves.transpose();
    result(0, 0) += lever * lever * covariance(2, 2);
    result(1, 1) += lever * lever * covariance(2, 2);
    return result;
  };
  const double query_lever = b_query_from_a_query.position().norm();
  const double target_lever = (b.target_from_query * b_query_from_a_query).position().norm();
  const Eigen::Matrix3d covariance = a.covariance + turned(queries.covariance, 0.0, 0.0) +
                                     turned(b.covariance, b_query_from_a_query.theta, query_lever) +
                                     turned(targets.covariance, -by_b.theta, target_lever);
  const Eigen::Vector3d e(error.x, error.y, error.theta);
  const double quantile = chi_square_quantile(options_.confidence, 3);
  if (e.dot(covariance.ldlt().solve(e)) > quantile) return {};
  return chance_within(covariance, quantile, std::min(a.window, b.window),
                       std::min(a.turn_window, b.turn_window));
}

PoseConstraint<Pose2> LoopCloser::constraint_of(const LoopMatch& match) const {
  return constraint_between(match, node_of(match.target), node_of(match.query));
}

// The shares of an ellipse in a disc, and of an interval in a longer one.
double chance_within(const Eigen::Matrix3d& covariance, double quantile, double window,
                     double turn_window) {
  const double place =
      quantile * std::sqrt(covariance.topLeftCorner<2, 2>().determinant()) / (window * window);
  const double turn = std::sqrt(quantile * covariance(2, 2)) / turn_window;
  return std::min(place, 1.0) * std::min(turn, 1.0);
}

PoseConstraint<Pose2> constraint_between(const LoopMatch& match, int target_node, int query_node) {
  return {.from = target_node,
          .to = query_node,
          .from_from_to = match.target_from_query,
          .information = match.covariance.inverse(),
          .closes_loop = true};
}

}  // namespace mapbed
