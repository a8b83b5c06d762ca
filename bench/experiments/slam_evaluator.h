#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/estimator.h"
#include "algorithms/grid/map_builder.h"
#include "bench/metrics/doubled_walls.h"
#include "bench/metrics/map_error.h"
#include "bench/metrics/relations.h"
#include "bench/metrics/trajectory_error.h"
#include "bench/results/results.h"
#include "bench/sources/run_input.h"

namespace mapbed {

enum class RelationStamps : int { odometry, linear };

struct EvaluationOptions {
  double success_distance = 1.0;        // [m]
  double success_doubled_walls = 0.01;  // fraction
  double failure_distance = 2.0;        // [m]
  double path_length = 5.0;             // [m]
  RelationStamps relation_stamps = RelationStamps::odometry;
  DoubledWallOptions doubled;
  MapOptions map;
};

template <class Visitor>
void visit_fields(EvaluationOptions& o, Visitor&& visit) {
  visit("success_distance", o.success_distance, Unit::meter, kPositive,
        "a success has a smaller largest_error");
  visit("success_doubled_walls", o.success_doubled_walls, kFraction,
        "and a smaller excess_doubled_walls");
  visit("failure_distance", o.failure_distance, Unit::meter, kPositive,
        "a run with a larger largest_error is a failure");
  visit("path_length", o.path_length, Unit::meter, between(0.01, 10'000.0),
        "of true path, over which relative errors are taken");
  visit("relation_stamps", o.relation_stamps, {"odometry", "linear"},
        "how stamps of relations between poses are reached: by the odometry that the log's "
        "description names for it (linearly where it names none), or linearly");
  visit("doubled", o.doubled, "what counts as a doubled wall");
  visit("map", o.map, "how the map is made of scans and poses");
}

// One run of SLAM against what is known of the way and the world. Whatever a metric needs is worked
// out when the first one asks; it is NaN where nobody knows the truth that it needs.
class SlamEvaluator {
 public:
  // All of these must outlive the evaluator.
  SlamEvaluator(const EvaluationOptions& options, const RunInput& input, const Estimate& estimate);

  const Pose2& world_from_map() const { return world_from_map_; }           // aligns the estimate
  const Trajectory& world_from_robot() const { return world_from_robot_; }  // the estimate, aligned
  const OccupancyMap& map();                                                // of these poses

  const Estimate& estimate() const { return estimate_; }
  const PoseErrors& absolute() const { return absolute_; }
  const PoseErrors& over_path() const { return over_path_; }
  double largest_error() const;  // [m] the first poses aligned
  double has_failed() const;     // 0 or 1
  const RelationsError& relations();
  double relations_compared();
  double log_error();  // [m] over relations that were measured, or else near pairs, see pairs.h
  const MapErrors& map_errors();
  double spurious_cells();
  const MapConfusion& confusion();
  double doubled_walls();         // fraction
  double excess_doubled_walls();  // above the fraction in the map of the same scans at true poses
  double success();               // 0 or 1

  // The values of the wanted metrics of the table below.
  std::vector<std::pair<std::string, double>> values();
  std::string failure() const;  // in one line; empty: it was none

 private:
  bool has_true_map() const { return !pairs_.empty() && input_.true_map; }
  const TrueMap& true_map() const { return input_.true_map(options_.map.resolution); }

  const EvaluationOptions& options_;
  const RunInput& input_;
  const Estimate& estimate_;
  std::vector<PosePair> pairs_;
  Pose2 world_from_map_;
  Trajectory world_from_robot_;
  PoseErrors absolute_;
  PoseErrors over_path_;
  std::optional<RelationsError> relations_;
  std::optional<OccupancyMap> map_;
  std::optional<MapErrors> map_errors_;
  std::optional<MapConfusion> confusion_;
  std::optional<double> doubled_walls_;
  std::optional<double> excess_doubled_walls_;
};

// Name, unit and meaning of all that a SlamEvaluator can tell.
std::vector<Metric> slam_metrics();

}  // namespace mapbed
