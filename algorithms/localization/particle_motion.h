#pragma once

#include <vector>

#include "algorithms/motion/motion_model.h"
#include "core/geometry/pose2.h"
#include "core/random.h"

namespace mapbed {

// Errors of odometry as they mostly are, and where wheels slip or readings jump.
struct ParticleErrors {
  MotionModelOptions usual{.rotation_per_rotation = 0.2, .rotation_per_meter = 0.15};
  double slip_share = 0.1;   // of the particles, which take the motion for one that slipped
  double slip_factor = 5.0;  // of the usual sigmas, for those
};

// A step of somebody of whose motion nothing is measured, about where he was: a person who carries
// an antenna, section 7.4. Variances grow with time.
struct RandomStepOptions {
  double position = 0.7;  // [m] sigma after 1 s
  double heading = 0.8;   // [rad] the same
};

template <class Visitor>
void visit_fields(RandomStepOptions& o, Visitor&& visit) {
  visit("position", o.position, Unit::meter, between(1e-3, 100.0), "sigma of a step after 1 s");
  visit("heading", o.heading, Unit::radian, between(1e-3, 100.0), "sigma of a turn after 1 s");
}

// p(x | u, x') of (7.3) for all particles: each is moved by a motion drawn about the measured one,
// or by a random step where none was measured. `streams` gives every block of particles its own
// chance, so that threads change nothing.
void move_particles(std::vector<Pose2>& map_from_robot, const Pose2& measured,
                    const ParticleErrors& errors, const Rng& streams);
void move_particles(std::vector<Pose2>& map_from_robot, double seconds,
                    const RandomStepOptions& steps, const Rng& streams);

}  // namespace mapbed
