#include "algorithms/submaps/graph_slam.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace mapbed {

GraphSlam::GraphSlam(const GraphSlamOptions& options, const Pose2& start)
    : options_(options),
      start_(start),
      chain_(options.chain),
      loops_({options.chain.submaps, options.loops.search.largest_window}, options.loops) {}

void GraphSlam::add(const Measurement& measurement, std::span<const float> beam_weights) {
  std::optional<NodeChain::NewSubmap> ended = chain_.add(measurement, beam_weights);
  append_nodes();
  if (ended) add_submap(*std::move(ended));
}

void GraphSlam::append_nodes() {
  const std::size_t known = graph_.nodes.size();
  chain_.append_nodes(graph_.nodes, start_);
  for (std::size_t node = std::max<std::size_t>(known, 1); node < graph_.nodes.size(); ++node) {
    graph_.constraints.push_back(chain_.steps()[node - 1]);
    weights_.push_back(1.0);
  }
}

void GraphSlam::add_submap(NodeChain::NewSubmap submap) {
  loops_.add(std::move(submap.submap), submap.node);
  const std::vector<LoopMatch> matches =
      loops_.find(static_cast<int>(loops_.size()) - 1, graph_, weights_);
  if (matches.empty()) return;
  believe(matches);
  optimize_graph(LoopStage::online);
}

void GraphSlam::believe(const std::vector<LoopMatch>& matches) {
  for (const LoopMatch& match : matches) {
    graph_.constraints.push_back(loops_.constraint_of(match));
    weights_.push_back(1.0);
  }
}

void GraphSlam::optimize_graph(LoopStage stage) {
  GraphOptimum<Pose2> optimum = optimize(graph_, loop_optimization(stage));
  graph_.nodes = std::move(optimum.poses);
  weights_ = std::move(optimum.weights);
}

void GraphSlam::finish() {
  if (std::optional<NodeChain::NewSubmap> last = chain_.end()) add_submap(*std::move(last));
  for (int query = 0; query < static_cast<int>(loops_.size()); ++query) {
    believe(loops_.find(query, graph_, weights_));
  }
  if (!graph_.nodes.empty()) optimize_graph(LoopStage::final);
}

Pose2 GraphSlam::pose() const {
  return graph_.nodes.empty() ? start_ : graph_.nodes.back() * chain_.from_newest_node();
}

Trajectory GraphSlam::path_so_far() const {
  return chain_.trajectory(graph_.nodes);
}

Estimate GraphSlam::estimate() const {
  Estimate result = chain_.estimate(graph_.nodes);
  if (graph_.nodes.empty()) return result;
  result.graph = believed(graph_, weights_);
  const auto loops =
      std::count_if(graph_.constraints.begin(), graph_.constraints.end(),
                    [](const PoseConstraint<Pose2>& constraint) { return constraint.closes_loop; });
  result.remarks.push_back(
      {RemarkKind::note,
       fmt::format("{} nodes, {} local maps, {} constraints that close loops, {} of them not "
                   "believed; {} matches that no other confirmed",
                   graph_.nodes.size(), loops_.size(), loops,
                   graph_.constraints.size() - result.graph->constraints.size(),
                   loops_.waiting())});
  return result;
}

}  // namespace mapbed
