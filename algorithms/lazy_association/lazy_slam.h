#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/estimator.h"
#include "algorithms/lazy_association/lazy_search.h"
#include "algorithms/lazy_association/lazy_slam_options.h"
#include "algorithms/lazy_association/submap_evidence.h"
#include "algorithms/submaps/loop_closer.h"
#include "algorithms/submaps/node_chain.h"
#include "algorithms/submaps/submap_fields.h"

namespace mapbed {

// Lazy data association, chapter 6: the path is a chain of local maps, and for each new one it is
// decided which earlier one shows the same place, or that it is a new place. The most likely
// decisions are taken, and taken back, however old they are, once others have become likelier
// (LazySearch). Decisions are compared by
//
//   ln p(z, x | u, c) = const - 1/2 J(x) + sum over local maps of ln p(z_t | z_1:t-1, x),
//
// x being the poses of the local maps at the least J, (6.7): the motions between neighbours and the
// equivalency constraints that c asks for, (6.4); the rest is what each local map saw of the places
// of those before, SubmapEvidence. Matches are scored at the optimum of J, not together with it, so
// that they can rise later: the search is a heuristic (lazy_search.h).
//
// At the end of the log the chosen decisions are constraints between the nodes of the chain, places
// that lie together then are matched too, as the method `graph` does, and the path is refined.
class LazySlam : public Estimator {
 public:
  // `start` is map_from_robot at the first scan.
  explicit LazySlam(const LazySlamOptions& options = {}, const Pose2& start = {});

  void add(const Measurement& measurement, std::span<const float> beam_weights = {}) override;
  void finish() override;
  Pose2 pose() const override;
  Estimate estimate() const override;
  Trajectory path_so_far() const override;

  const AssociationTree& associations() const { return search_.tree(); }

 private:
  // Of a node of the tree.
  struct Hypothesis {
    std::vector<Pose2> poses;        // map_from_submap
    std::optional<LoopMatch> match;  // that its own decision asks for
    double chi_square = 0.0;         // J
    double log_likelihood = 0.0;
    double newest = 0.0;  // of it, what the newest local map has in it

    // What a right constraint in the plane costs in the mean, 3 / 2: nothing speaks against it.
    double expected_cost() const { return match ? 1.5 : 0.0; }
  };
  // A search for one local map in another.
  struct Searched {
    Pose2 target_from_query;  // as it was predicted
    double window = 0.0, turn_window = 0.0;
    std::optional<SubmapMatch> match;
  };
  void add_submap(NodeChain::NewSubmap submap);
  std::vector<LazySearch::Outcome> expanded(std::size_t node);
  void judge(Hypothesis& hypothesis);
  void note_paths();
  PoseGraph<Pose2> graph_of(std::size_t node, int query) const;
  std::vector<LoopMatch> matches_of(const std::vector<LoopCandidate>& candidates, int query);
  std::optional<SubmapMatch> searched(const LoopCandidate& candidate, int query);
  std::vector<Pose2> nodes_of(const std::vector<Pose2>& submap_poses) const;

  LazySlamOptions options_;
  Pose2 start_;
  NodeChain chain_;
  std::vector<Submap> submaps_;
  std::vector<int> frames_;  // node whose frame each local map has
  std::vector<TimeInterval> when_;
  std::vector<PoseConstraint<Pose2>> motions_;  // from each local map to the next one
  SubmapFields fields_;
  std::map<std::pair<int, int>, std::vector<Searched>> searches_;  // by target and query
  SubmapEvidence evidence_;
  LazySearch search_;
  std::vector<Hypothesis> hypotheses_;  // by node of the tree
  struct Paths {
    Trajectory before, after;
  };
  std::vector<Paths> revised_;  // by revision
  std::optional<PoseGraph<Pose2>> finished_;
  int refused_ = 0;  // constraints that the graph did not believe in the end
};

}  // namespace mapbed
