#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/config/option.h"
#include "sim/actors/navigation_map.h"

namespace mapbed {

// The headed social force model (Farina, Fontanelli, Garulli, Giannitrapani, Prattichizzo: Walking
// Ahead, PLoS ONE 12(1), 2017). People have a heading r_f and prefer to walk along it:
//
//   f_0 = m (v_wish - v) / tau                                   what they want
//   f_e = sum_j (A exp(o / B) + k1 g(o)) n + k2 g(o) (dv t) t    others and walls,
//         o = sum of radii - distance, g(o) = max(o, 0)
//   m dv_f/dt = (f_0 + f_e) r_f
//   m dv_o/dt = k_o f_e r_o - k_d v_o
//   dw/dt     = -k_l |f_0| (theta - theta_0) - (1 + alpha) sqrt(k_l |f_0| / alpha) w
//
// with theta_0 the direction of f_0; the moment of inertia cancels. Where f_0 dies away, so would
// the turn before it is complete: half of m v_wish / tau is added to it, for the heading alone.
struct SocialForceOptions {
  double relaxation = 0.5;    // [s] tau
  double repulsion = 2000.0;  // [N] A
  double range = 0.08;        // [m] B
  double stiffness = 1.2e5;   // [kg/s^2] k1
  double friction = 2.4e5;    // [kg/(m s)] k2
  double sideways = 1.0;      // k_o
  double damping = 500.0;     // [kg/s] k_d
  double heading = 0.3;       // [1/(kg m)] k_l
  double alpha = 3.0;         // alpha
  double shoulder = 0.8;      // fraction of the radius that counts at walls: shoulders turn
};

struct Walker {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // [m/s] in the world frame
  double heading = 0.0;                                // [rad]
  double turn_rate = 0.0;                              // [rad/s]
  double radius = 0.3;                                 // [m]
  double mass = 75.0;                                  // [kg]
  Eigen::Vector2d wish = Eigen::Vector2d::Zero();      // [m/s] the velocity it would like
  bool keeps_heading = false;                          // looks where it looks, standing
  double wished_heading = 0.0;                         // [rad] where keeps_heading
};

// Something round that people walk around and never through: a robot.
struct RoundObstacle {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // [m/s]
  double radius = 0.3;                                 // [m]
};

// All walkers `dt` later; steps of 5 ms are stable. Whatever the forces do, nobody's middle comes
// nearer to a wall than 0.7 of the shoulders' radius, nor into a robot where walls leave room.
void advance(std::vector<Walker>& walkers, const NavigationMap& map, std::span<const Wall> doors,
             std::span<const RoundObstacle> robots, const SocialForceOptions& options, double dt);

template <class Visitor>
void visit_fields(SocialForceOptions& o, Visitor&& visit) {
  visit("relaxation", o.relaxation, Unit::second, between(0.01, 100.0),
        "tau: to reach the wished velocity");
  visit("repulsion", o.repulsion, Unit::newton, between(0.0, 1e5), "A: at touching distance");
  visit("range", o.range, Unit::meter, between(0.001, 10.0), "B: over which it falls by e");
  visit("stiffness", o.stiffness, between(0.0, 1e7), "k1 [kg/s^2]: of bodies that touch");
  visit("friction", o.friction, between(0.0, 1e7), "k2 [kg/(m s)]: of bodies that touch");
  visit("sideways", o.sideways, between(0.0, 100.0), "k_o: fraction of forces that acts sideways");
  visit("damping", o.damping, between(0.0, 1e5), "k_d [kg/s]: against walking sideways");
  visit("heading", o.heading, between(1e-4, 100.0), "k_lambda [1/(kg m)]: turning into the way");
  visit("alpha", o.alpha, between(0.01, 100.0), "damping of that turn");
  visit("shoulder", o.shoulder, between(0.3, 1.0), "fraction of the radius that counts at walls");
}

}  // namespace mapbed
