#pragma once

#include <numbers>
#include <vector>

#include "core/config/option.h"
#include "core/log/bag_options.h"

namespace mapbed {

enum class Stamp : int { ipc, logger };

enum class ZeroReading : int { failed, no_return };

// The wheels of a robot whose log holds encoder ticks; the defaults are those of the robot of the
// CoreSLAM logs.
struct WheelGeometry {
  double wheel_radius = 0.077;    // [m]
  double half_track = 0.165;      // [m] from the robot's centre to either wheel
  double ticks_per_turn = 2000;   // of one wheel
  double left_right_ratio = 1.0;  // radius of the right wheel over that of the left one
};

template <class Visitor>
void visit_fields(WheelGeometry& o, Visitor&& visit) {
  visit("wheel_radius", o.wheel_radius, Unit::meter, between(1e-4, 100.0), "radius of a wheel");
  visit("half_track", o.half_track, Unit::meter, between(1e-3, 100.0),
        "from the robot's centre to either wheel");
  visit("ticks_per_turn", o.ticks_per_turn, between(1.0, 1e9),
        "encoder ticks in one turn of a wheel");
  visit("left_right_ratio", o.left_right_ratio, between(0.01, 100.0),
        "right wheel's radius over the left one's");
}

// What a log does not say about its sensors, or says wrongly. 0 and empty lists mean: as detected.
struct LogOptions {
  double field_of_view = 0.0;                 // [rad] the beams lie symmetrically about the front
  std::vector<double> first_bearing = {};     // [rad] none, or one
  double bearing_step = 0.0;                  // [rad]
  double max_range = 0.0;                     // [m] readings from here on mean: nothing was hit
  ZeroReading zero = ZeroReading::failed;     // what a reading of 0 says
  std::vector<double> robot_from_laser = {};  // none, or x [m], y [m], theta [rad]
  std::vector<double> robot_from_rear_laser = {};  // none, or x [m], y [m], theta [rad]
  Stamp stamp = Stamp::ipc;                        // of the two stamps that a CARMEN line has
  double reorder_within = 1.0;  // [s] a stamp may be older than one before by this
  double scan_period = 0.1;     // [s] between scans of logs that have no stamps
  double longest = 0.0;         // [s] from the first measurement on that is kept; 0: everything
  double max_text = 1e9;        // [bytes] of text, after unpacking
  WheelGeometry wheels = {};    // for logs of encoder ticks
  BagOptions bag = {};          // for bags of ROS
};

template <class Visitor>
void visit_fields(LogOptions& o, Visitor&& visit) {
  visit("field_of_view", o.field_of_view, Unit::radian, between(0.0, 2.0 * std::numbers::pi),
        "angle that the beams cover, symmetric about the front; 0: as detected");
  visit("first_bearing", o.first_bearing, Unit::radian,
        "one number: bearing of the first beam; none: as detected");
  visit("bearing_step", o.bearing_step, Unit::radian, between(-6.3, 6.3),
        "from beam to beam; 0: as detected");
  visit("max_range", o.max_range, Unit::meter, kNotNegative,
        "readings from here on mean that nothing was hit; 0: as detected");
  visit("zero", o.zero, {"failed", "no_return"},
        "what a reading of 0 says: nothing at all, or that nothing was hit up to max_range");
  visit("robot_from_laser", o.robot_from_laser,
        "x [m], y [m], theta [rad] of the front laser on the robot; none: as detected");
  visit("robot_from_rear_laser", o.robot_from_rear_laser,
        "x [m], y [m], theta [rad] of the rear laser on the robot; none: as detected");
  visit("stamp", o.stamp, {"ipc", "logger"}, "which of a CARMEN line's two stamps is its time");
  visit("reorder_within", o.reorder_within, Unit::second, kNotNegative,
        "measurements late by up to this are put in order; later ones are an error");
  visit("scan_period", o.scan_period, Unit::second, between(1e-6, 1e6),
        "between scans of logs that have no stamps");
  visit("longest", o.longest, Unit::second, kNotNegative,
        "how much of the log, from its first measurement on, is used; 0: all of it");
  visit("max_text", o.max_text, between(1.0, 1e12),
        "largest text, in bytes after unpacking, that is read; of bags: memory of what is used");
  visit("wheels", o.wheels, "the robot's wheels, for logs of encoder ticks");
  visit("bag", o.bag, "topics and frames, for bags of ROS");
}

}  // namespace mapbed
