#pragma once

#include <Eigen/Core>

#include "algorithms/motion/pose_prior.h"
#include "core/config/option.h"
#include "core/geometry/rotation_translation_rotation.h"
#include "core/random.h"

namespace mapbed {

// Section 5.3, Figure 5.2: each part of a motion, alpha, d and beta, has an error of its own that
// grows with the motion:
//
//   sigma_alpha^2 = rotation_per_rotation^2 |alpha| + rotation_per_meter^2 |d|
//                   + least_rotation_sigma^2,                       the same for beta
//   sigma_d^2     = translation_per_meter^2 |d| + translation_per_rotation^2 (|alpha| + |beta|)
//                   + least_translation_sigma^2
//
// Variances, not sigmas, grow with the length of the motion, so that two halves err as the whole.
struct MotionModelOptions {
  double rotation_per_rotation = 0.15;     // [rad] sigma after 1 rad
  double rotation_per_meter = 0.08;        // [rad] after 1 m
  double translation_per_meter = 0.10;     // [m] after 1 m
  double translation_per_rotation = 0.03;  // [m] after 1 rad
  double least_rotation_sigma = 0.005;     // [rad]
  double least_translation_sigma = 0.005;  // [m] also sideways
  double rotation_bias = 0.0;              // mean error of rotations, as a fraction of them
  double translation_bias = 0.0;           // the same of translations
};

template <class Visitor>
void visit_fields(MotionModelOptions& o, Visitor&& visit) {
  visit("rotation_per_rotation", o.rotation_per_rotation, Unit::radian, between(0.0, 10.0),
        "sigma of a rotation after 1 rad");
  visit("rotation_per_meter", o.rotation_per_meter, Unit::radian, between(0.0, 10.0),
        "sigma of a rotation after 1 m");
  visit("translation_per_meter", o.translation_per_meter, Unit::meter, between(0.0, 10.0),
        "sigma of the translation after 1 m");
  visit("translation_per_rotation", o.translation_per_rotation, Unit::meter, between(0.0, 10.0),
        "sigma of the translation after 1 rad");
  visit("least_rotation_sigma", o.least_rotation_sigma, Unit::radian, between(1e-6, 10.0),
        "sigma of a rotation at least");
  visit("least_translation_sigma", o.least_translation_sigma, Unit::meter, between(1e-6, 10.0),
        "sigma of the translation at least");
  visit("rotation_bias", o.rotation_bias, between(-0.9, 0.9),
        "mean error of rotations, as a fraction of them");
  visit("translation_bias", o.translation_bias, between(-0.9, 0.9),
        "mean error of translations, as a fraction of them");
}

// A motion as the models see it; below a centimetre its direction means nothing.
RotationTranslationRotation parts_of(const Pose2& motion);

// A motion that may have happened where `measured` was measured.
Pose2 sampled_motion(const Pose2& measured, const MotionModelOptions& options, Rng& rng);

// The same as a Gaussian about the likeliest motion, from `start`: what proposals and searches use.
PosePrior gaussian_after(const Pose2& start, const Pose2& measured,
                         const MotionModelOptions& options);

}  // namespace mapbed
