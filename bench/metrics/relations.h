#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/trajectory.h"

namespace mapbed {

// The relations metric: R. Kümmerle et al., "On Measuring the Accuracy of SLAM Algorithms",
// Autonomous Robots 27 (2009). A person has measured how the robot moved between pairs of stamps;
// the error of a pair is
//
//   inverse(relation) * inverse(estimate at from_time) * (estimate at to_time),
//
// of which the translation's length and the rotation's absolute value count. No alignment, and a
// bent map is not punished more at its far end.
struct Relation {
  double from_time = 0.0;  // [s] absolute, as in the log
  double to_time = 0.0;    // [s] may be the earlier one
  Pose2 from_to;           // the later robot frame in the earlier one
};

// Lines "t1 t2 x y z roll pitch yaw" [s], [m], [rad], plain or gzip; z, roll and pitch are not
// used. Throws InputError.
std::vector<Relation> load_relations(const std::string& path);
std::vector<Relation> parse_relations(const std::string& name, std::string_view text);

// What was measured of the way through a log.
struct MeasuredRelations {
  std::vector<Relation> relations;
  Trajectory odometry;  // reaches stamps between the poses of an estimate; may be empty
};

struct RelationsError {
  int count = 0;                 // relations that were compared
  int skipped = 0;               // relations with a stamp more than 5 s outside the estimate
  double mean_translation = 0;   // [m] NaN where count is 0, as all below
  double sigma_translation = 0;  // [m] of the population
  double mean_rotation = 0;      // [rad]
  double sigma_rotation = 0;     // [rad] of the population
};

// A stamp between two poses is reached by odometry from both and blended by time; without odometry
// it lies linearly between them. A stamp up to 5 s outside takes odometry from the outermost pose
// (without odometry: that pose). Neither trajectory need be in order; the estimate is not empty.
RelationsError relations_error(const Trajectory& estimate, const std::vector<Relation>& relations,
                               const Trajectory& odometry = {});

}  // namespace mapbed
