#include "algorithms/submaps/node_chain.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

#include "algorithms/scan/beam_weights.h"
#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {

NodeChain::NodeChain(const NodeChainOptions& options)
    : options_(options), matcher_(options.matcher) {}

std::optional<NodeChain::NewSubmap> NodeChain::add(const Measurement& measurement,
                                                   std::span<const float> beam_weights) {
  const auto* told = std::get_if<LaserScan>(&measurement);
  if (told != nullptr && !lasers_.take(*told)) return {};
  matcher_.add(measurement, beam_weights);
  if (told == nullptr) return {};
  const LaserScan& scan = beam_weights.empty() ? *told : with_failed_beams(*told, beam_weights);
  const Pose2 track_from_robot = matcher_.pose();
  const ScanMatch& match = matcher_.last_match();
  if (!scans_.empty()) {
    if (!match.trustworthy && match.points_used > 0) known_ = std::max(known_, Known::by_odometry);
    if (match.contradicts_prediction) known_ = Known::poorly;
  }
  ++scans_since_node_;
  const bool due = is_due(track_from_robot);
  if (due) add_node(scan, beam_weights);
  scans_.push_back({scan.time, track_from_robot, track_from_nodes_.size(), due});
  KeptHits& kept = hits_.emplace_back();
  if (!due && options_.refinement.enabled) {
    for (const Eigen::Vector2d& hit : hit_points(scan, options_.points)) {
      kept.push_back(hit.cast<float>());
    }
  }
  if (static_cast<int>(extents_.size()) < options_.submaps.keyframes) return {};
  return end();
}

bool NodeChain::is_due(const Pose2& track_from_robot) const {
  if (track_from_nodes_.empty()) return true;
  const Pose2& before = track_from_nodes_.back();
  return distance(before, track_from_robot) >= options_.node_distance ||
         std::abs(angle_difference(before.theta, track_from_robot.theta)) >= options_.node_turn;
}

void NodeChain::add_node(const LaserScan& scan, std::span<const float> beam_weights) {
  const Pose2 track_from_robot = matcher_.pose();
  if (!track_from_nodes_.empty()) {
    const Pose2 motion = motion_between(track_from_nodes_.back(), track_from_robot);
    const int node = static_cast<int>(track_from_nodes_.size());
    steps_.push_back({.from = node - 1,
                      .to = node,
                      .from_from_to = motion,
                      .information = step_to(motion, scan.time - node_times_.back()).information});
  }
  known_ = Known::by_scans;
  scans_since_node_ = 0;
  track_from_nodes_.push_back(track_from_robot);
  node_times_.push_back(scan.time);
  node_scans_.push_back(
      scan_for_weighting(scan, options_.points, {}, options_.map_resolution, beam_weights));
  extents_.emplace_back(scan, options_.submaps.max_range, BeamLimits{}.no_return_range);
}

// The motion to a new node from the one before, as a belief. Without odometry a scan may say
// nothing of how far the robot went along a bare corridor: then only that it went on as before.
PosePrior NodeChain::step_to(const Pose2& motion, double seconds) const {
  if (known_ == Known::by_scans) {
    PosePrior step = gaussian_after({}, motion, options_.matching_errors);
    if (const auto unknown = matcher_.blind_spread(scans_since_node_, seconds)) {
      step.information = (step.information.inverse() + *unknown).inverse();
    }
    return step;
  }
  if (known_ == Known::by_odometry) return gaussian_after({}, motion, options_.odometry_errors);
  // Found without regard to odometry, within this window.
  const CorrelativeMatcherOptions& search = options_.matcher.wide_search;
  return independent_prior(motion, search.window, search.window, search.turn_window / 2.0);
}

std::optional<NodeChain::NewSubmap> NodeChain::end() {
  if (extents_.empty()) return {};
  const std::size_t count = extents_.size(), first = nodes() - count, middle = first + count / 2;
  std::vector<SubmapScan> scans;
  for (std::size_t i = 0; i < count; ++i) {
    scans.push_back({motion_between(track_from_nodes_[middle], track_from_nodes_[first + i]),
                     node_scans_[first + i].surface, std::move(extents_[i])});
  }
  extents_.clear();
  return NewSubmap{make_submap(scans, options_.submaps),
                   static_cast<int>(middle),
                   {node_times_[first], node_times_.back()}};
}

void NodeChain::append_nodes(std::vector<Pose2>& map_from_nodes, const Pose2& start) const {
  if (map_from_nodes.empty() && nodes() > 0) map_from_nodes.push_back(start);
  while (map_from_nodes.size() < nodes()) {
    map_from_nodes.push_back(map_from_nodes.back() *
                             steps_[map_from_nodes.size() - 1].from_from_to);
  }
}

Pose2 NodeChain::from_newest_node() const {
  if (track_from_nodes_.empty()) return {};
  return motion_between(track_from_nodes_.back(), matcher_.pose());
}

Track NodeChain::track() const {
  return {.scans = scans_,
          .track_from_anchors = track_from_nodes_,
          .breaks = {},
          .errors = options_.matching_errors};
}

Trajectory NodeChain::trajectory(const std::vector<Pose2>& map_from_nodes) const {
  return carried_trajectory(track(), map_from_nodes);
}

Estimate NodeChain::estimate(const std::vector<Pose2>& map_from_nodes) const {
  CHECK(map_from_nodes.size() == nodes());
  Estimate result = matcher_.estimate();
  for (Remark& remark : lasers_.remarks()) result.remarks.push_back(std::move(remark));
  if (map_from_nodes.empty()) return result;
  const Track track = this->track();
  if (options_.refinement.enabled) {
    const RefinedPath better = refined(map_from_nodes, node_scans_, track, options_.refinement);
    result.trajectory = refined_trajectory(better, track, hits_, options_.refinement);
  } else {
    result.trajectory = carried_trajectory(track, map_from_nodes);
  }
  return result;
}

}  // namespace mapbed
