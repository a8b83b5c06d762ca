#pragma once

#include "sim/drivers/scripted_driver.h"

namespace mapbed {

struct OmniDriverOptions : PathFollowingOptions {
  bool faces_way = false;   // turns to where it drives; else it keeps its heading
  double turn_speed = 0.5;  // [rad/s] at most, while it does
};

template <class Visitor>
void visit_fields(OmniDriverOptions& o, Visitor&& visit) {
  visit_fields(static_cast<PathFollowingOptions&>(o), visit);
  visit("faces_way", o.faces_way, "turns to where it drives; no: it keeps its heading");
  visit("turn_speed", o.turn_speed, Unit::radian_per_second, between(0.001, 100.0),
        "fastest turn, where it faces its way");
}

// The scripted driver on wheels that go in any direction: it drives straight to where it wants,
// sideways and backwards too, and turns as it goes or not at all.
class OmniDriver : public ScriptedDriver {
 public:
  OmniDriver(const Simulation& simulation, const NamedPath& path,
             const OmniDriverOptions& options = {})
      : ScriptedDriver(simulation, path, options), options_(options) {}

 private:
  DriveCommand steer(const Eigen::Vector2d& to, double speed) override;
  DriveCommand back_up() const override;

  OmniDriverOptions options_;
  Eigen::Vector2d last_way_{1.0, 0.0};  // in the world: where it drove before it made room
};

}  // namespace mapbed
