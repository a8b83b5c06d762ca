#pragma once

#include <vector>

#include "core/config/option.h"
#include "core/geometry/trajectory.h"

namespace mapbed {

// Errors of a trajectory against true (or reference) poses, defined as the program `evo` does, so
// that its figures and ours can stand in one table. The definitions are those of J. Sturm et al.,
// "A Benchmark for the Evaluation of RGB-D SLAM Systems", IROS 2012.

// Two poses of one moment.
struct PosePair {
  double time = 0.0;  // [s] the estimate's stamp
  Pose2 truth;        // world_from_robot
  Pose2 estimate;     // map_from_robot
};

// For every pose of the shorter trajectory the nearest one in time of the other, where it is not
// further than `max_time_difference` [s]. In order of time.
std::vector<PosePair> associated(const Trajectory& truth, const Trajectory& estimate,
                                 double max_time_difference = 0.01);

struct ErrorStatistics {
  int count = 0;
  double rmse = 0.0;  // NaN where count is 0, as all below
  double mean = 0.0;
  double median = 0.0;
  double sigma = 0.0;  // of the population
  double min = 0.0;
  double max = 0.0;
};

struct PoseErrors {
  ErrorStatistics translation;  // [m]
  ErrorStatistics rotation;     // [rad] of absolute values
};

ErrorStatistics statistics_of(std::vector<double> errors);

// world_from_map that brings the estimated positions nearest to the true ones, without scale
// (Umeyama 1991). With fewer than two different positions: the one that matches the first pose.
Pose2 alignment(const std::vector<PosePair>& pairs);

// ATE (evo: APE): distance and turn between the true and the aligned estimated poses.
PoseErrors absolute_error(const std::vector<PosePair>& pairs, const Pose2& world_from_map);

enum class PathUnit : int { frames, meters };

struct RelativeErrorOptions {
  double delta = 1.0;  // from the first pose of a pair to the second
  PathUnit unit = PathUnit::frames;
  bool all_pairs = false;  // a pair from every pose on; else the next starts where one ends
  double tolerance = 0.1;  // of delta; all pairs in metres: how well the best end must fit
};

// RPE: the motion from one pose to another against the true one. Lengths in metres are measured
// along the estimated path, as `evo` does by default.
PoseErrors relative_error(const std::vector<PosePair>& pairs, const RelativeErrorOptions& options);

// For every true stamp, the motion until the first later true stamp that is at least `length` [m]
// of true path away, against the estimate at the two stamps (interpolated; none outside its time).
PoseErrors error_over_path(const Trajectory& truth, const Trajectory& estimate, double length);

template <class Visitor>
void visit_fields(RelativeErrorOptions& o, Visitor&& visit) {
  visit("delta", o.delta, between(1e-6, 1e6),
        "length of the motions that are compared, in frames or metres");
  visit("unit", o.unit, {"frames", "meters"}, "what delta counts; metres along the estimate");
  visit("all_pairs", o.all_pairs, "a pair from every pose on, instead of one behind the other");
  visit("tolerance", o.tolerance, between(0.0, 100.0),
        "fraction of delta by which the best end of a pair may be off");
}

}  // namespace mapbed
