#include "sim/noise/odometry_noise.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"
#include "core/geometry/rotation_translation_rotation.h"

namespace mapbed {
namespace {

constexpr double kStandingStill = 1e-6;  // [m] less has no direction

// What is no drive at all is one rotation.
RotationTranslationRotation parts_of(const Pose2& motion) {
  if (std::hypot(motion.x, motion.y) < kStandingStill) return {0.0, 0.0, motion.theta};
  return decomposed(motion, kStandingStill);
}

// Sigma of a turn on the way.
double turn_sigma(const OdometryModel& m, double way, double turn) {
  return std::sqrt(m.end_turn_per_meter * m.end_turn_per_meter * way +
                   m.end_turn_per_radian * m.end_turn_per_radian * std::abs(turn));
}

Pose2 noisy_components(const Pose2& motion, const OdometryModel& m, Rng& rng) {
  const double turn = angle_difference(0.0, motion.theta);
  const double sigma = turn_sigma(m, std::hypot(motion.x, motion.y), turn);
  Pose2 noisy = motion;
  noisy.x += m.distance_bias * motion.x +
             m.distance_per_meter * std::sqrt(std::abs(motion.x)) * rng.normal();
  noisy.y += m.sideways_bias * motion.y +
             m.sideways_per_meter * std::sqrt(std::abs(motion.y)) * rng.normal();
  noisy.theta += m.end_turn_bias * turn + sigma * rng.normal();
  return noisy;
}

Pose2 noisy_turns(const Pose2& motion, const OdometryModel& m, Rng& rng) {
  RotationTranslationRotation s = parts_of(motion);
  const double way = std::abs(s.translation);
  const double turn = angle_difference(0.0, motion.theta);
  const double root = std::sqrt(way);
  const double end_sigma = turn_sigma(m, way, turn);
  s.first_rotation +=
      m.start_turn_bias * s.translation + m.start_turn_per_meter * root * rng.normal();
  s.translation += m.distance_bias * s.translation + m.distance_per_meter * root * rng.normal();
  s.second_rotation += m.end_turn_bias * turn + end_sigma * rng.normal();

  return composed(s);
}

Pose2 noisy_motion(const Pose2& motion, const OdometryModel& m, Rng rng) {
  const bool is_turns = m.errors == OdometryErrors::turns;
  Pose2 noisy = is_turns ? noisy_turns(motion, m, rng) : noisy_components(motion, m, rng);
  noisy.x += m.translation_sigma * rng.normal();
  noisy.y += m.translation_sigma * rng.normal();
  noisy.theta = normalized_angle(noisy.theta + m.rotation_sigma * rng.normal());
  return noisy;
}

}  // namespace

Odometry OdometryReader::read(const IdealOdometry& ideal) {
  if (count_ > 0) {
    const bool wheels = model_.source == OdometrySource::wheels;
    const Pose2 motion = wheels ? motion_between(last_.wheels, ideal.wheels)
                                : motion_between(last_.truth, ideal.truth);
    pose_ = pose_ * noisy_motion(motion, model_, rng_.stream("odometry", count_));
  }
  ++count_;
  last_ = ideal;
  return {ideal.time, pose_, ideal.forward_velocity, ideal.turn_velocity};
}

}  // namespace mapbed
