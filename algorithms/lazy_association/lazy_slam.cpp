#include "algorithms/lazy_association/lazy_slam.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "algorithms/pose_graph/graph_optimizer.h"
#include "algorithms/submaps/loop_graph.h"
#include "algorithms/submaps/reach.h"
#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr double kSamePlace = 0.2;  // [m]
constexpr double kSameTurn = 0.03;  // [rad]

// Of one node as seen from an earlier one, by the steps between them.
PoseConstraint<Pose2> steps_together(const std::vector<PoseConstraint<Pose2>>& steps, int first,
                                     int last) {
  Pose2 motion;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (int i = first; i < last; ++i) {
    const PoseConstraint<Pose2>& step = steps[static_cast<std::size_t>(i)];
    covariance = seen_from(covariance, inverse(step.from_from_to)) +
                 Eigen::Matrix3d(step.information.inverse());
    motion = motion * step.from_from_to;
  }
  return {.from_from_to = motion, .information = covariance.inverse()};
}

bool lies_within(const LoopCandidate& wanted, const Pose2& centre, double window,
                 double turn_window) {
  return distance(wanted.target_from_query, centre) + wanted.window <= window + 0.25 &&
         std::abs(angle_difference(wanted.target_from_query.theta, centre.theta)) +
                 wanted.turn_window <=
             turn_window + 0.05;
}

// Whether all local maps lie at the same places, as far as anybody would see.
bool is_same_map(const std::vector<Pose2>& a, const std::vector<Pose2>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (distance(a[i], b[i]) > kSamePlace ||
        std::abs(angle_difference(a[i].theta, b[i].theta)) > kSameTurn) {
      return false;
    }
  }
  return true;
}

}  // namespace

LazySlam::LazySlam(const LazySlamOptions& options, const Pose2& start)
    : options_(options),
      start_(start),
      chain_(options.chain),
      fields_(options.chain.submaps, options.loops.search.largest_window),
      evidence_(options.evidence),
      search_(options.search) {}

void LazySlam::add(const Measurement& measurement, std::span<const float> beam_weights) {
  std::optional<NodeChain::NewSubmap> ended = chain_.add(measurement, beam_weights);
  if (ended) add_submap(*std::move(ended));
}

void LazySlam::add_submap(NodeChain::NewSubmap submap) {
  if (!frames_.empty()) {
    motions_.push_back(steps_together(chain_.steps(), frames_.back(), submap.node));
    motions_.back().from = static_cast<int>(frames_.size()) - 1;
    motions_.back().to = static_cast<int>(frames_.size());
  }
  evidence_.add(submap.submap);
  submaps_.push_back(std::move(submap.submap));
  frames_.push_back(submap.node);
  when_.push_back(submap.when);
  if (search_.empty()) {
    std::vector<Pose2> nodes;
    chain_.append_nodes(nodes, start_);
    Hypothesis first{.poses = {nodes[static_cast<std::size_t>(submap.node)]}, .match = {}};
    judge(first);
    search_.start({.log_likelihood = first.log_likelihood, .newest = first.newest});
    hypotheses_.push_back(std::move(first));
    return;
  }
  // Its neighbours lie to it as under any hypothesis.
  const std::vector<Pose2>& before = hypotheses_[search_.chosen()].poses;
  std::vector<Pose2> poses = before;
  poses.push_back(before.back() * motions_.back().from_from_to);
  const double most =
      evidence_.of_a_new_place(static_cast<int>(before.size()), poses, options_.loops.search.apart);
  search_.advance(submap.when.to, [this](std::size_t node) { return expanded(node); },
                  {.value = most, .is_bound = false});
  note_paths();
}

// Of a revision that the newest local map brought, if any.
void LazySlam::note_paths() {
  const auto& revisions = search_.tree().revisions;
  if (revised_.size() == revisions.size()) return;
  const auto path_of = [&](std::size_t node) {
    return chain_.trajectory(nodes_of(hypotheses_[node].poses));
  };
  revised_.push_back({path_of(revisions.back().before), path_of(revisions.back().after)});
}

// The local maps up to `query` under the decisions up to a node, with their poses there.
PoseGraph<Pose2> LazySlam::graph_of(std::size_t node, int query) const {
  PoseGraph<Pose2> graph{.nodes = hypotheses_[node].poses, .constraints = {}};
  for (int i = 0; i < query; ++i) {
    graph.constraints.push_back(motions_[static_cast<std::size_t>(i)]);
    if (i >= static_cast<int>(graph.nodes.size()) - 1) {
      graph.nodes.push_back(graph.nodes.back() *
                            motions_[static_cast<std::size_t>(i)].from_from_to);
    }
  }
  for (const std::size_t decided : search_.path_to(node)) {
    if (const std::optional<LoopMatch>& match = hypotheses_[decided].match) {
      graph.constraints.push_back(constraint_between(*match, match->target, match->query));
    }
  }
  return graph;
}

// Where a local map may lie in others: known from an earlier search that looked there too, or
// searched for.
std::optional<SubmapMatch> LazySlam::searched(const LoopCandidate& candidate, int query) {
  std::vector<Searched>& before = searches_[{candidate.target, query}];
  for (const Searched& search : before) {
    if (!lies_within(candidate, search.target_from_query, search.window, search.turn_window)) {
      continue;
    }
    if (!search.match) return {};
    const Pose2& found = search.match->target_from_query;
    const bool is_in_window =
        distance(found, candidate.target_from_query) <= 1.5 * candidate.window &&
        std::abs(angle_difference(found.theta, candidate.target_from_query.theta)) <=
            candidate.turn_window;
    if (is_in_window) return search.match;
  }
  const auto target = static_cast<std::size_t>(candidate.target);
  const auto field_of_target = fields_.of(submaps_[target], candidate.target);
  const auto field_of_query = fields_.of(submaps_[static_cast<std::size_t>(query)], query);
  before.push_back(
      {candidate.target_from_query, candidate.window, candidate.turn_window,
       match_submaps(submaps_[target], *field_of_target, submaps_[static_cast<std::size_t>(query)],
                     *field_of_query, candidate.target_from_query, candidate.window,
                     candidate.turn_window, options_.loops.matching, Rivals::ignored)});
  return before.back().match;
}

std::vector<LoopMatch> LazySlam::matches_of(const std::vector<LoopCandidate>& candidates,
                                            int query) {
  std::vector<LoopMatch> matches;
  for (const LoopCandidate& candidate : candidates) {
    const std::optional<SubmapMatch> match = searched(candidate, query);
    if (!match) continue;
    matches.push_back({candidate.target, query, match->target_from_query, match->covariance,
                       candidate.window, candidate.turn_window});
  }
  return matches;
}

// Every decision about the next local map: a new place, or one of those that it may show. Decisions
// that leave all local maps where they are under another one are the same map and would multiply
// with each local map: the likelier one stands for both.
std::vector<LazySearch::Outcome> LazySlam::expanded(std::size_t node) {
  const int query = static_cast<int>(hypotheses_[node].poses.size());
  PoseGraph<Pose2> graph = graph_of(node, query);
  const auto count = static_cast<std::size_t>(query) + 1;
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  const std::vector<LoopCandidate> candidates = loop_candidates(
      {std::span(submaps_).first(count), numbers}, query, graph, {}, options_.loops.search);
  std::vector<Hypothesis> possible;
  possible.push_back(
      {.poses = graph.nodes, .match = {}, .chi_square = hypotheses_[node].chi_square});
  for (const LoopMatch& match : matches_of(candidates, query)) {
    graph.constraints.push_back(constraint_between(match, match.target, match.query));
    GraphOptimum<Pose2> optimum = optimize(graph);
    graph.constraints.pop_back();
    possible.push_back(
        {.poses = std::move(optimum.poses), .match = match, .chi_square = optimum.chi2_after});
  }
  for (Hypothesis& hypothesis : possible) judge(hypothesis);
  std::vector<std::size_t> likeliest_first(possible.size());
  std::iota(likeliest_first.begin(), likeliest_first.end(), std::size_t{0});
  std::stable_sort(likeliest_first.begin(), likeliest_first.end(),
                   [&](std::size_t a, std::size_t b) {
                     return possible[a].log_likelihood + possible[a].expected_cost() >
                            possible[b].log_likelihood + possible[b].expected_cost();
                   });
  std::vector<LazySearch::Outcome> outcomes;
  const std::size_t first = hypotheses_.size();
  for (const std::size_t next : likeliest_first) {
    Hypothesis& hypothesis = possible[next];
    const auto same = std::find_if(
        hypotheses_.begin() + static_cast<std::ptrdiff_t>(first), hypotheses_.end(),
        [&](const Hypothesis& kept) { return is_same_map(kept.poses, hypothesis.poses); });
    if (same != hypotheses_.end()) continue;
    outcomes.push_back({.associated = hypothesis.match ? hypothesis.match->target : -1,
                        .log_likelihood = hypothesis.log_likelihood,
                        .newest = hypothesis.newest});
    hypotheses_.push_back(std::move(hypothesis));
  }
  return outcomes;
}

void LazySlam::judge(Hypothesis& hypothesis) {
  const int newest = static_cast<int>(hypothesis.poses.size()) - 1;
  hypothesis.newest = evidence_.log_likelihood(newest, hypothesis.poses);
  hypothesis.log_likelihood =
      -0.5 * hypothesis.chi_square + evidence_.log_likelihood(hypothesis.poses);
}

// Where the nodes of the chain are, each by the local map that it belongs to.
std::vector<Pose2> LazySlam::nodes_of(const std::vector<Pose2>& submap_poses) const {
  std::vector<Pose2> track;
  chain_.append_nodes(track, start_);
  std::size_t submap = 0;
  std::vector<Pose2> nodes;
  for (std::size_t node = 0; node < track.size(); ++node) {
    // The frame is in the middle: the first nodes after a local map belong to the next one.
    const auto middle_of = [&](std::size_t i) { return static_cast<std::size_t>(frames_[i]); };
    while (submap + 1 < submap_poses.size() &&
           node >= (middle_of(submap) + middle_of(submap + 1) + 1) / 2) {
      ++submap;
    }
    nodes.push_back(submap_poses.empty()
                        ? track[node]
                        : submap_poses[submap] *
                              motion_between(track[middle_of(submap)], track[node]));
  }
  if (!nodes.empty()) nodes.front() = start_;  // without the last bits of going there and back
  return nodes;
}

void LazySlam::finish() {
  if (std::optional<NodeChain::NewSubmap> last = chain_.end()) add_submap(*std::move(last));
  if (search_.empty()) return;
  const Hypothesis& chosen = hypotheses_[search_.chosen()];
  PoseGraph<Pose2> graph{.nodes = nodes_of(chosen.poses), .constraints = chain_.steps()};
  LoopCloser loops(std::move(fields_), options_.loops);  // nobody asks for fields any more
  for (std::size_t i = 0; i < submaps_.size(); ++i) loops.add(submaps_[i], frames_[i]);
  for (const std::size_t decided : search_.path_to(search_.chosen())) {
    if (const std::optional<LoopMatch>& match = hypotheses_[decided].match) {
      graph.constraints.push_back(loops.constraint_of(*match));
    }
  }
  GraphOptimum<Pose2> optimum = optimize(graph, loop_optimization(LoopStage::online));
  graph.nodes = std::move(optimum.poses);
  for (int query = 0; query < static_cast<int>(loops.size()); ++query) {
    for (const LoopMatch& match : loops.find(query, graph, optimum.weights)) {
      graph.constraints.push_back(loops.constraint_of(match));
      optimum.weights.push_back(1.0);
    }
  }
  optimum = optimize(graph, loop_optimization(LoopStage::final));
  graph.nodes = std::move(optimum.poses);
  finished_ = believed(graph, optimum.weights);
  refused_ = static_cast<int>(graph.constraints.size() - finished_->constraints.size());
}

Pose2 LazySlam::pose() const {
  if (chain_.nodes() == 0) return start_;
  if (finished_) return finished_->nodes.back() * chain_.from_newest_node();
  const std::vector<Pose2> nodes =
      nodes_of(search_.empty() ? std::vector<Pose2>{} : hypotheses_[search_.chosen()].poses);
  return nodes.back() * chain_.from_newest_node();
}

Trajectory LazySlam::path_so_far() const {
  if (finished_) return chain_.trajectory(finished_->nodes);
  return chain_.trajectory(
      nodes_of(search_.empty() ? std::vector<Pose2>{} : hypotheses_[search_.chosen()].poses));
}

Estimate LazySlam::estimate() const {
  const std::vector<Pose2> nodes =
      finished_
          ? finished_->nodes
          : nodes_of(search_.empty() ? std::vector<Pose2>{} : hypotheses_[search_.chosen()].poses);
  Estimate result = chain_.estimate(nodes);
  if (nodes.empty()) return result;
  result.graph = finished_;
  if (search_.empty()) return result;
  AssociationTree tree = search_.tree();
  tree.local_maps = when_;
  for (std::size_t i = 0; i < revised_.size(); ++i) {
    tree.revisions[i].path_before = revised_[i].before;
    tree.revisions[i].path_after = revised_[i].after;
  }
  const std::vector<std::size_t> path = search_.path_to(tree.chosen);
  const auto loops = std::count_if(
      path.begin(), path.end(), [&](std::size_t node) { return tree.nodes[node].associated >= 0; });
  result.remarks.push_back(
      {RemarkKind::note,
       fmt::format("{} local maps, {} of them at places of earlier ones; {} hypotheses, {} times "
                   "decisions about the past were taken back; at {} local maps the search ended "
                   "early; {} constraints not believed in the end",
                   submaps_.size(), loops, tree.nodes.size(), tree.revisions.size(), tree.given_up,
                   refused_)});
  result.associations = std::move(tree);
  return result;
}

}  // namespace mapbed
