#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/metrics/relations.h"
#include "bench/metrics/trajectory_error.h"

namespace mapbed {

struct TruthOptions {
  double max_time_difference = 0.01;  // [s] between an estimated and a true pose of one moment
  RelativeErrorOptions relative;
  double path_length = 5.0;  // [m] of the true path, for the error over a length of path
};

// An estimate against true or reference poses.
struct TruthErrors {
  TruthOptions options;
  int true_poses = 0;
  int true_with_estimate = 0;  // of the same moment, as below
  int estimated_poses = 0;
  int estimated_with_truth = 0;
  int estimated_outside = 0;  // before the first true pose or after the last one
  int pairs = 0;              // that are compared: of the trajectory with fewer poses
  Pose2 world_from_map;       // the alignment before `absolute`
  PoseErrors absolute = {};   // ATE
  PoseErrors relative = {};   // RPE
  PoseErrors over_path = {};  // for each path_length of the true path
};

// Throws InputError where the two share no moment. Neither trajectory need be in order.
TruthErrors compare_with_truth(Trajectory estimate, Trajectory truth, const TruthOptions& options);

// What `mapbed evaluate` found out about an estimate.
struct Evaluation {
  std::optional<RelationsError> relations;
  std::optional<TruthErrors> truth;
};

std::string table_of(const Evaluation& evaluation);  // for people, lines with their units
std::string json_of(const Evaluation& evaluation);   // for programs, all digits

}  // namespace mapbed
