#include "algorithms/submaps/graph_slam.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "algorithms/pose_graph/graph_optimizer.h"
#include "algorithms/scan/beam_weights.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr double kBelieved = 0.5;  // weight of a constraint

}  // namespace

GraphSlam::GraphSlam(const GraphSlamOptions& options, const Pose2& start)
    : options_(options), start_(start), matcher_(options.matcher), loops_(options.loops) {}

void GraphSlam::add(const Measurement& measurement, std::span<const float> beam_weights) {
  const auto* scan = std::get_if<LaserScan>(&measurement);
  if (scan != nullptr && !lasers_.take(*scan)) return;
  matcher_.add(measurement, beam_weights);
  if (scan == nullptr) return;
  add_scan(beam_weights.empty() ? *scan : with_failed_beams(*scan, beam_weights), beam_weights);
}

void GraphSlam::add_scan(const LaserScan& scan, std::span<const float> beam_weights) {
  const Pose2 track_from_robot = matcher_.pose();
  const ScanMatch& match = matcher_.last_match();
  if (!scans_.empty()) {
    if (!match.trustworthy && match.points_used > 0) known_ = std::max(known_, Known::by_odometry);
    if (match.contradicts_prediction) known_ = Known::poorly;
  }
  const bool is_due =
      scans_.empty() ||
      distance(track_from_nodes_.back(), track_from_robot) >= options_.node_distance ||
      std::abs(angle_difference(track_from_nodes_.back().theta, track_from_robot.theta)) >=
          options_.node_turn;
  if (is_due) add_node(scan, beam_weights);
  scans_.push_back({scan.time, track_from_robot, track_from_nodes_.size(), is_due});
  KeptHits& kept = hits_.emplace_back();
  if (is_due || !options_.refinement.enabled) return;
  for (const Eigen::Vector2d& hit : hit_points(scan, options_.points)) {
    kept.push_back(hit.cast<float>());
  }
}

// The motion to a new node from the one before.
PosePrior GraphSlam::error_of(const Pose2& motion, double seconds) const {
  if (known_ == Known::by_scans) return gaussian_after({}, motion, options_.matching_errors);
  if (known_ == Known::by_odometry) return gaussian_after({}, motion, options_.odometry_errors);
  const double window = options_.matcher.wide_search.window;
  (void)seconds;
  return independent_prior(motion, window, window, window);
}

void GraphSlam::add_node(const LaserScan& scan, std::span<const float> beam_weights) {
  const Pose2 track_from_robot = matcher_.pose();
  Pose2 map_from_node = start_;
  if (!graph_.nodes.empty()) {
    const Pose2 motion = motion_between(track_from_nodes_.back(), track_from_robot);
    map_from_node = graph_.nodes.back() * motion;
    const int node = static_cast<int>(graph_.nodes.size());
    graph_.constraints.push_back(
        {.from = node - 1,
         .to = node,
         .from_from_to = motion,
         .information = error_of(motion, scan.time - node_times_.back()).information});
    weights_.push_back(1.0);
  }
  known_ = Known::by_scans;
  graph_.nodes.push_back(map_from_node);
  track_from_nodes_.push_back(track_from_robot);
  node_times_.push_back(scan.time);
  node_scans_.push_back(
      scan_for_weighting(scan, options_.points, {}, options_.map_resolution, beam_weights));
  views_.emplace_back(scan, options_.loops.submaps.max_range, BeamLimits{}.no_return_range);
  if (static_cast<int>(views_.size()) == options_.loops.submaps.keyframes) end_submap();
}

void GraphSlam::end_submap() {
  if (views_.empty()) return;
  const std::size_t count = views_.size(), first = graph_.nodes.size() - count;
  const std::size_t middle = first + count / 2;
  std::vector<SubmapScan> scans;
  for (std::size_t i = 0; i < count; ++i) {
    scans.push_back({motion_between(track_from_nodes_[middle], track_from_nodes_[first + i]),
                     node_scans_[first + i].surface, std::move(views_[i])});
  }
  views_.clear();
  loops_.add(make_submap(scans, options_.loops.submaps), static_cast<int>(middle));
  believe(loops_.find(static_cast<int>(loops_.size()) - 1, graph_, weights_));
}

void GraphSlam::believe(const std::vector<LoopMatch>& matches) {
  if (matches.empty()) return;
  for (const LoopMatch& match : matches) {
    graph_.constraints.push_back(loops_.constraint_of(match));
    weights_.push_back(1.0);
  }
  optimize_graph(false);
}

void GraphSlam::optimize_graph(bool finally) {
  GraphOptimizationOptions options;
  options.robust.loss = finally ? RobustLoss::graduated_truncated : RobustLoss::switchable;
  options.robust.width = 3.0;
  GraphOptimum<Pose2> optimum = optimize(graph_, options);
  graph_.nodes = std::move(optimum.poses);
  weights_ = std::move(optimum.weights);
}

void GraphSlam::finish() {
  end_submap();
  for (int query = 0; query < static_cast<int>(loops_.size()); ++query) {
    for (const LoopMatch& match : loops_.find(query, graph_, weights_)) {
      graph_.constraints.push_back(loops_.constraint_of(match));
      weights_.push_back(1.0);
    }
  }
  if (!graph_.nodes.empty()) optimize_graph(true);
}

Pose2 GraphSlam::pose() const {
  if (graph_.nodes.empty()) return start_;
  return graph_.nodes.back() * motion_between(track_from_nodes_.back(), matcher_.pose());
}

Track GraphSlam::track() const {
  return {.scans = scans_,
          .track_from_anchors = track_from_nodes_,
          .breaks = {},
          .errors = options_.matching_errors};
}

Trajectory GraphSlam::path_so_far() const {
  if (graph_.nodes.empty()) return {};
  return carried_trajectory(track(), graph_.nodes);
}

PoseGraph<Pose2> GraphSlam::believed() const {
  PoseGraph<Pose2> graph{.nodes = graph_.nodes, .constraints = {}};
  for (std::size_t i = 0; i < graph_.constraints.size(); ++i) {
    if (weights_[i] >= kBelieved) graph.constraints.push_back(graph_.constraints[i]);
  }
  return graph;
}

Estimate GraphSlam::estimate() const {
  if (graph_.nodes.empty()) return {};
  Estimate result = matcher_.estimate();
  for (Remark& remark : lasers_.remarks()) result.remarks.push_back(std::move(remark));
  const Track track = this->track();
  if (options_.refinement.enabled) {
    const RefinedPath better = refined(graph_.nodes, node_scans_, track, options_.refinement);
    result.trajectory = refined_trajectory(better, track, hits_, options_.refinement);
  } else {
    result.trajectory = carried_trajectory(track, graph_.nodes);
  }
  const auto loops =
      std::count_if(graph_.constraints.begin(), graph_.constraints.end(),
                    [](const PoseConstraint<Pose2>& constraint) { return constraint.closes_loop; });
  const auto refused = std::count_if(weights_.begin(), weights_.end(),
                                     [](double weight) { return weight < kBelieved; });
  result.remarks.push_back(
      {RemarkKind::note,
       fmt::format("{} nodes, {} local maps, {} constraints that close loops, {} of them not "
                   "believed; {} matches that no other confirmed",
                   graph_.nodes.size(), loops_.size(), loops, refused, loops_.waiting())});
  return result;
}

}  // namespace mapbed
