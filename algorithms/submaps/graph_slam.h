#pragma once

#include <vector>

#include "algorithms/estimator.h"
#include "algorithms/submaps/graph_slam_options.h"
#include "algorithms/submaps/loop_closer.h"
#include "algorithms/submaps/loop_graph.h"
#include "algorithms/submaps/node_chain.h"

namespace mapbed {

// The method `graph`, as most of today's programs work: the nodes of a chain are those of a graph;
// pieces of the path, each with its local map, are looked for in those before (LoopCloser), and
// where one is found that is a constraint. The nodes are where all constraints together have them
// likeliest, with a robust loss for those that may be wrong; at the end of the log by graduated
// non-convexity, after another look for places that were seen twice. A path that lies right is
// refined by all scans together.
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
  void append_nodes();
  void add_submap(NodeChain::NewSubmap submap);
  void believe(const std::vector<LoopMatch>& matches);
  void optimize_graph(LoopStage stage);

  GraphSlamOptions options_;
  Pose2 start_;
  NodeChain chain_;
  PoseGraph<Pose2> graph_;
  std::vector<double> weights_;  // of the constraints
  LoopCloser loops_;
};

}  // namespace mapbed
