#pragma once

#include <optional>
#include <vector>

#include "algorithms/estimator.h"
#include "algorithms/field/surface_likelihood.h"
#include "algorithms/motion/motion_model.h"
#include "algorithms/motion/track.h"
#include "algorithms/pose_graph/pose_graph.h"
#include "algorithms/refinement/trajectory_refinement.h"
#include "algorithms/scan/beam.h"
#include "algorithms/scan/level_lasers.h"
#include "algorithms/scan_matching/incremental_matcher.h"
#include "algorithms/submaps/submap.h"
#include "core/config/option.h"

namespace mapbed {

struct NodeChainOptions {
  double node_distance = 0.5;   // [m] of motion between nodes
  double node_turn = 0.4;       // [rad] of turn between nodes
  double map_resolution = 0.1;  // [m] of the surfaces that are kept
  HitPointOptions points{.max_range = 30.0, .min_spacing = 0.1, .max_points = 90};
  MotionModelOptions odometry_errors{.rotation_per_rotation = 0.2, .rotation_per_meter = 0.15};
  MotionModelOptions matching_errors{.rotation_per_rotation = 0.02,
                                     .rotation_per_meter = 0.01,
                                     .translation_per_meter = 0.02,
                                     .translation_per_rotation = 0.015,
                                     .least_rotation_sigma = 0.002,
                                     .least_translation_sigma = 0.004};
  IncrementalMatcherOptions matcher{.weigh_footprints = true,
                                    .points = {.max_range = BeamLimits{}.usable_range},
                                    .local_map = {.max_scans = 40}};
  SubmapOptions submaps;
  RefinementOptions refinement{.enabled = true};
};

template <class Visitor>
void visit_fields(NodeChainOptions& o, Visitor&& visit) {
  visit("node_distance", o.node_distance, Unit::meter, kNotNegative, "motion between nodes");
  visit("node_turn", o.node_turn, Unit::radian, kNotNegative, "turn between nodes");
  visit("map_resolution", o.map_resolution, Unit::meter, between(0.01, 2.0),
        "of the surfaces that nodes keep");
  visit("points", o.points, "which points of a scan are refined");
  visit("odometry_errors", o.odometry_errors, "errors of raw odometry");
  visit("matching_errors", o.matching_errors, "errors of scan matching from node to node");
  visit("matcher", o.matcher, "scan matching between nodes");
  visit("submaps", o.submaps, "pieces of the path whose maps are matched with each other");
  visit("refinement", o.refinement, "all scans of the path together");
}

// What methods with a graph share: scan matching makes the path; scans that are far enough from
// each other are nodes, each with a constraint to the one before, as well as its motion is known;
// so many nodes make a local map. Where all nodes are is the methods' own business.
class NodeChain {
 public:
  explicit NodeChain(const NodeChainOptions& options);

  struct NewSubmap {
    Submap submap;
    int node = 0;  // whose frame it has
    TimeInterval when;
  };
  // The local map that ended with a measurement, if one did.
  std::optional<NewSubmap> add(const Measurement& measurement, std::span<const float> beam_weights);
  std::optional<NewSubmap> end();  // of the log: what is left, if anything

  // From each node to the next one; constraint i leads to node i + 1.
  const std::vector<PoseConstraint<Pose2>>& steps() const { return steps_; }
  std::size_t nodes() const { return track_from_nodes_.size(); }
  // Where the steps from the last of some nodes lead, up to the newest one.
  void append_nodes(std::vector<Pose2>& map_from_nodes, const Pose2& start) const;
  Pose2 from_newest_node() const;  // the robot now, in the frame of the newest node

  // The path, where its nodes lie at such poses.
  Trajectory trajectory(const std::vector<Pose2>& map_from_nodes) const;
  // The same refined, where options say so, with what scan matching has to remark.
  Estimate estimate(const std::vector<Pose2>& map_from_nodes) const;

 private:
  // By what the motion since the last node is known.
  enum class Known { by_scans, by_odometry, poorly };
  bool is_due(const Pose2& track_from_robot) const;
  void add_node(const LaserScan& scan, std::span<const float> beam_weights);
  PosePrior step_to(const Pose2& motion, double seconds) const;
  Track track() const;

  NodeChainOptions options_;
  LevelLasers lasers_;
  IncrementalMatcher matcher_;
  std::vector<Track::Scan> scans_;
  std::vector<Pose2> track_from_nodes_;
  std::vector<double> node_times_;  // [s]
  std::vector<ScanForWeighting> node_scans_;
  std::vector<KeptHits> hits_;       // for refinement, of each scan but those of nodes
  std::vector<ScanExtent> extents_;  // of the local map that is being made
  Known known_ = Known::by_scans;
  int scans_since_node_ = 0;
  std::vector<PoseConstraint<Pose2>> steps_;
};

}  // namespace mapbed
