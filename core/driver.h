#pragma once

#include <limits>

#include "core/sensor/measurement.h"

namespace mapbed {

// What the wheels shall do; the robot's limits of speed and acceleration hold on top.
struct DriveCommand {
  double forward_velocity = 0.0;  // [m/s]
  double turn_velocity = 0.0;  // [rad/s] positive: counter-clockwise; a car's wheels are steered so
                               // that it turns by this at the forward velocity
  double left_velocity = 0.0;  // [m/s] of robots that can drive sideways
};

// Who sits at the wheel, on a real robot as in simulation: measurements in, drive command out.
class Driver {
 public:
  virtual ~Driver() = default;
  virtual void add(const Measurement& measurement) = 0;  // in order of time
  virtual DriveCommand command(double time) = 0;         // asked regularly, time in [s] growing
  virtual bool is_done() const = 0;                      // the drive is over
  virtual bool is_resting(double /*time*/) const { return false; }  // it stands still on purpose
  // [s] a drive that takes longer has gone wrong.
  virtual double longest_time() const { return std::numeric_limits<double>::infinity(); }
};

}  // namespace mapbed
