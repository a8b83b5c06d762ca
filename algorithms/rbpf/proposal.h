#pragma once

#include <optional>

#include <Eigen/Core>

#include "algorithms/motion/motion_model.h"
#include "algorithms/motion/motion_prior.h"
#include "algorithms/motion/pose_prior.h"
#include "core/random.h"

namespace mapbed {

// Where the particles of an update are drawn from.
enum class Proposal : int {
  odometry,       // the standard filter: raw odometry with its error model; where there is none,
                  // the robot is taken to stand still
  scan_matching,  // section 5.3: the scans since the last update, condensed into one corrected
                  // motion
  improved,  // Grisetti et al. 2007: the posterior of the update's own scan in each particle's map
};

// Of the robot from the last update to the one to be made.
struct UpdateMotion {
  Pose2 whole;      // by odometry and scan matching
  Pose2 condensed;  // up to the last scan that was matched before the update's
  // Beyond the errors of matching: covariance of (x, y, theta) in the frame of its end.
  std::optional<Eigen::Matrix3d> condensed_doubt = {};
  std::optional<Pose2> step;  // on from there, by odometry; none: there is none
  double seconds = 0.0;       // of that step
  Pose2 guess;                // with the help of the update's scan
  // Where the best particle's map explains clearly more of the scan than near the guess.
  std::optional<Pose2> other_guess = {};
  bool guess_is_doubtful = false;  // the update's scan fits nowhere near, or one before it did not
  // The scan fits nowhere near where the step ends, but elsewhere: wheels that spun, odometry that
  // missed a turn. What the step says then counts for nothing.
  bool step_contradicted = false;
};

// What the two parts of such a motion are worth.
struct MotionErrors {
  MotionModelOptions condensed;  // errors of matching
  MotionModelOptions odometry;
  MotionPriorOptions blind;  // a step without odometry
  // Of a contradicted step: anywhere in the window that was searched.
  double contradicted_translation = 1.0;  // [m]
  double contradicted_rotation = 3.15;    // [rad]
};

// Where a particle is before the update's scan is looked at: after the condensed motion, whose
// errors are those of matching and its doubt, and a step of odometry, or one of unknown speed.
PosePrior prior_after(const Pose2& start, const UpdateMotion& motion, const MotionErrors& errors);

// A pose drawn from a Gaussian; errors are (x, y, theta) in the mean's frame.
Pose2 drawn_from(const Pose2& mean, const Eigen::Matrix3d& covariance, Rng& rng);

}  // namespace mapbed
