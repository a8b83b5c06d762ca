#pragma once

#include <Eigen/Core>

#include "algorithms/field/likelihood_field.h"
#include "core/config/option.h"

namespace mapbed {

struct MatchCovarianceOptions {
  double probe_step = 0.01;  // [m] over which slopes are compared: as coarse as the noise of beams
  double turn_per_meter = 0.5;  // [rad/m] the same for turns
  int beams_together = 10;      // neighbouring points whose errors are alike
};

template <class Visitor>
void visit_fields(MatchCovarianceOptions& o, Visitor&& visit) {
  visit("probe_step", o.probe_step, Unit::meter, between(1e-5, 1.0),
        "over which the slopes of the likelihood are compared");
  visit("turn_per_meter", o.turn_per_meter, Unit::radian_per_meter, between(1e-3, 100.0),
        "size of turns beside that of steps");
  visit("beams_together", o.beams_together, between(1, 100'000),
        "neighbouring points of a scan whose errors are alike");
}

// How far the optimum of ln p(z | x, m) + ln p(x) may lie from the true pose: of (x, y, theta) in
// the frame of the optimum, as of an estimator by slopes (Huber's sandwich).
//
// Knows only what lies about this optimum: not that another one may be the right one.
struct MatchInformation {
  // H: how fast the slope of ln p(z | x, m) changes over probe_step to either side. A map of cells
  // follows a scan that is moved by less than its noise, so that its curvature at a point promises
  // more than a match can keep.
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();
  // S, the sum over groups of points of s s^T, s the slope that a group of neighbouring points
  // pulls with. What neighbours err in common (the wall of the map that they lie on) so counts
  // once, not once for each.
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();

  // (H + P)^-1 (S + P) (H + P)^-1, P being the information of the prediction p(x).
  Eigen::Matrix3d covariance(const Eigen::Matrix3d& of_prediction = Eigen::Matrix3d::Zero()) const;
  // H S^-1 H, of the scan alone: 0 in directions in which it says nothing.
  Eigen::Matrix3d information() const;
};

MatchInformation match_information(const Pose2& optimum, const FieldPoints& points,
                                   const LikelihoodField& map,
                                   const MatchCovarianceOptions& options = {});

}  // namespace mapbed
