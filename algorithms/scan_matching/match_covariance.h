#pragma once

#include <Eigen/Core>

#include "algorithms/grid/likelihood_field.h"
#include "core/geometry/pose_prior.h"

namespace mapbed {

// How far a match may be off: the covariance of (x, y, theta) of inverse(estimate) * truth, in the
// robot's frame [m^2, m rad, rad^2].
//
// The field's sigma is wider than the noise (it smooths the search), so the curvature alone would
// not be calibrated. With H the curvature of the log-likelihood at the estimate, S the scatter of
// the beams' gradients about zero and P the prior's information, the covariance is that of an
// M-estimator (Huber 1967),  (H + P)^-1 (c S + P) (H + P)^-1.  Neighbouring beams that end on the
// same map cell share that cell's error; c is the mean number of them. In a corridor S and H vanish
// along it, and the prior's spread remains.
Eigen::Matrix3d match_covariance(const FieldPoints& points, const LikelihoodField& map,
                                 const PosePrior& prediction, const Pose2& map_from_robot);

}  // namespace mapbed
