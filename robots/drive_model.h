#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "core/config/option.h"

namespace mapbed {

enum class DriveKind : int {
  synchro,       // all wheels steer together; turns without scrubbing
  differential,  // two driven wheels and a caster
  skid_steer,    // four fixed wheels; turns by scrubbing
  omni,          // four wheels with rollers; drives in any direction as it turns
  ackermann,     // a car: two steered wheels ahead of two fixed ones; the origin is between them
};

// As files write them, by the kind's number.
inline const std::vector<std::string>& drive_kind_names() {
  static const std::vector<std::string> names{"synchro", "differential", "skid_steer", "omni",
                                              "ackermann"};
  return names;
}
inline const std::string& name_of(DriveKind kind) {
  return drive_kind_names()[static_cast<std::size_t>(kind)];
}

// How the robot's wheels meet the floor.
struct DriveModel {
  DriveKind kind = DriveKind::differential;
  double max_speed = 0.8;          // [m/s]
  double max_turn_speed = 1.5;     // [rad/s]
  double acceleration = 0.5;       // [m/s^2]
  double turn_acceleration = 2.0;  // [rad/s^2]
  double track = 0.4;              // [m] between left and right wheels
  double wheel_base = 0.0;         // [m] between front and rear axle
  double friction = 0.7;           // Coulomb, wheel on floor
  double surface_spread = 0.0;     // relative sigma of sideways against lengthwise friction ...
  double surface_patch = 2.0;      // [m] ... drawn anew for every square patch of floor
  double wheel_spread = 0.0;       // relative sigma of a wheel's radius, drawn once a robot
  double max_steering = 0.5;       // [rad] of a car's front wheels, to either side
  double steering_rate = 1.0;      // [rad/s] at which they are turned
  double steering_spread = 0.0;    // [rad] sigma of their zero, drawn once a robot

  // [m] the least circle of the middle between a car's rear wheels; 0: turns on the spot.
  double turning_radius() const {
    return kind == DriveKind::ackermann ? wheel_base / std::tan(max_steering) : 0.0;
  }
};

template <class Visitor>
void visit_fields(DriveModel& o, Visitor&& visit) {
  visit("kind", o.kind, drive_kind_names(), "how the wheels are arranged");
  visit("max_speed", o.max_speed, Unit::meter_per_second, between(0.001, 100.0),
        "fastest forward or back");
  visit("max_turn_speed", o.max_turn_speed, Unit::radian_per_second, between(0.001, 100.0),
        "fastest turn");
  visit("acceleration", o.acceleration, Unit::meter_per_second_squared, between(0.001, 1000.0),
        "of the wheels, speeding up or braking");
  visit("turn_acceleration", o.turn_acceleration, Unit::radian_per_second_squared,
        between(0.001, 1000.0), "the same for turning");
  visit("track", o.track, Unit::meter, between(0.01, 100.0), "between left and right wheels");
  visit("wheel_base", o.wheel_base, Unit::meter, between(0.0, 100.0),
        "between front and rear axle");
  visit("friction", o.friction, between(0.001, 10.0), "wheel on floor (Coulomb)");
  visit("surface_spread", o.surface_spread, between(0.0, 10.0),
        "relative sigma of sideways against lengthwise friction from patch to patch of floor");
  visit("surface_patch", o.surface_patch, Unit::meter, between(0.01, 10'000.0),
        "side of such a patch");
  visit("wheel_spread", o.wheel_spread, between(0.0, 0.1),
        "relative sigma of the wheels' radii, drawn once a robot");
  visit("max_steering", o.max_steering, Unit::radian, between(0.01, 1.4),
        "of a car's front wheels, to either side");
  visit("steering_rate", o.steering_rate, Unit::radian_per_second, between(0.001, 100.0),
        "at which a car's front wheels are turned");
  visit("steering_spread", o.steering_spread, Unit::radian, between(0.0, 0.5),
        "sigma of the zero of a car's steering, drawn once a robot");
}

}  // namespace mapbed
