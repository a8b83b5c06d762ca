#pragma once

#include "algorithms/pose_graph/pose_graph.h"

namespace mapbed {

// The pose after a step: positions move in the map's frame, so that errors are linear in them, and
// rotations turn in the pose's own frame, in space by the rotation vector [rad].
Pose2 moved(const Pose2& pose, const PoseTangent<Pose2>& step);
Pose3 moved(const Pose3& pose, const PoseTangent<Pose3>& step);

// (6.4), in g2o's coordinates; see PoseConstraint.
PoseTangent<Pose2> constraint_error(const Pose2& from_from_to, const Pose2& map_from_from,
                                    const Pose2& map_from_to);
PoseTangent<Pose3> constraint_error(const Pose3& from_from_to, const Pose3& map_from_from,
                                    const Pose3& map_from_to);

// The error, and its derivatives by the steps of both nodes.
template <class Pose>
struct LinearError {
  PoseTangent<Pose> error;
  PoseInformation<Pose> by_from;
  PoseInformation<Pose> by_to;
};

LinearError<Pose2> linear_error(const Pose2& from_from_to, const Pose2& map_from_from,
                                const Pose2& map_from_to);
LinearError<Pose3> linear_error(const Pose3& from_from_to, const Pose3& map_from_from,
                                const Pose3& map_from_to);

// error' information error
template <class Pose>
double chi_square_of(const PoseConstraint<Pose>& constraint, const std::vector<Pose>& nodes) {
  const PoseTangent<Pose> error =
      constraint_error(constraint.from_from_to, nodes[static_cast<std::size_t>(constraint.from)],
                       nodes[static_cast<std::size_t>(constraint.to)]);
  return error.dot(constraint.information * error);
}

}  // namespace mapbed
