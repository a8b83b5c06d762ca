#pragma once

#include "sim/drivers/scripted_driver.h"

namespace mapbed {

struct TurningDriverOptions : PathFollowingOptions {
  double turns = 1.0;       // at each point of the path; negative: clockwise
  double turn_speed = 0.5;  // [rad/s]
};

template <class Visitor>
void visit_fields(TurningDriverOptions& o, Visitor&& visit) {
  visit_fields(static_cast<PathFollowingOptions&>(o), visit);
  visit("turns", o.turns, between(-1000.0, 1000.0),
        "on the spot at each point of the path; negative: clockwise");
  visit("turn_speed", o.turn_speed, Unit::radian_per_second, between(0.001, 100.0), "of that");
}

// The scripted driver, who turns round at each point of the path, the first and the last as well,
// before he goes on: what a sensor says from all sides.
class TurningDriver : public ScriptedDriver {
 public:
  TurningDriver(const Simulation& simulation, const NamedPath& path,
                const TurningDriverOptions& options = {});

  DriveCommand command(double time) override;
  bool is_resting(double time) const override {
    return is_turning_ || ScriptedDriver::is_resting(time);
  }
  bool is_done() const override { return !is_turning_ && ScriptedDriver::is_done(); }
  double longest_time() const override;

 private:
  DriveCommand turn();

  TurningDriverOptions options_;
  std::size_t stops_ = 0;   // of the path
  bool is_turning_ = true;  // at the first point
  double turned_ = 0.0;     // [rad] so far
  double heading_ = 0.0;    // [rad] when it was asked last
};

}  // namespace mapbed
