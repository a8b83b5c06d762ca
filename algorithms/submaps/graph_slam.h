#pragma once

#include <vector>

#include "algorithms/estimator.h"
#include "algorithms/field/surface_likelihood.h"
#include "algorithms/motion/track.h"
#include "algorithms/refinement/trajectory_refinement.h"
#include "algorithms/scan/level_lasers.h"
#include "algorithms/scan_matching/incremental_matcher.h"
#include "algorithms/submaps/graph_slam_options.h"
#include "algorithms/submaps/loop_closer.h"

namespace mapbed {

// The method `graph`, as most of today's programs work: scan matching makes the path; scans that
// are far enough from each other are the nodes of a graph; pieces of the path, each with its local
// map, are looked for in those before (LoopCloser), and where one is found that is a constraint.
// The nodes are where all constraints together have them likeliest, with a robust loss for those
// that may be wrong; at the end of the log by graduated non-convexity, after another look for
// places that were seen twice. A path that lies right is refined by all scans together.
class GraphSlam : public Estimator {
 public:
  // `start` is map_from_robot at the first scan.
  explicit GraphSlam(const GraphSlamOptions& options = {}, const Pose2& start = {});

  void add(const Measurement& measurement, std::span<const float> beam_weights = {}) override;
  void finish() override;
  Pose2 pose() const override;
  Estimate estimate() const override;
  Trajectory path_so_far() const override;

 private:
  // By what the path since the last node is known.
  enum class Known { by_scans, by_odometry, poorly };
  void add_scan(const LaserScan& scan, std::span<const float> beam_weights);
  void add_node(const LaserScan& scan, std::span<const float> beam_weights);
  void end_submap();
  void believe(const std::vector<LoopMatch>& matches);
  void optimize_graph(bool finally);
  PosePrior error_of(const Pose2& motion, double seconds) const;
  Track track() const;
  PoseGraph<Pose2> believed() const;

  GraphSlamOptions options_;
  Pose2 start_;
  LevelLasers lasers_;
  IncrementalMatcher matcher_;
  std::vector<Track::Scan> scans_;
  std::vector<Pose2> track_from_nodes_;
  std::vector<double> node_times_;
  std::vector<ScanForWeighting> node_scans_;
  std::vector<KeptHits> hits_;     // for refinement, of each scan but those of nodes
  std::vector<ScanView> views_;    // of the local map that is being made
  Known known_ = Known::by_scans;  // the motion since the last node
  PoseGraph<Pose2> graph_;
  std::vector<double> weights_;  // of the constraints
  LoopCloser loops_;
};

}  // namespace mapbed
