#pragma once

#include "core/config/option.h"
#include "core/driver.h"
#include "sim/simulation.h"

namespace mapbed {

struct ScriptedDriverOptions {
  double speed = 0.4;           // [m/s] where the path does not say
  double look_ahead = 0.6;      // [m] the point of the path that is steered for
  double margin = 0.12;         // [m] kept from walls
  double people_margin = 0.25;  // [m] kept from people
  double patience = 3.0;        // [s] waits for somebody in the way, then goes round
};

template <class Visitor>
void visit_fields(ScriptedDriverOptions& o, Visitor&& visit) {
  visit("speed", o.speed, Unit::meter_per_second, between(0.001, 100.0),
        "where the path does not say");
  visit("look_ahead", o.look_ahead, Unit::meter, between(0.01, 100.0),
        "how far ahead it steers for");
  visit("margin", o.margin, Unit::meter, between(0.0, 10.0), "distance kept from walls");
  visit("people_margin", o.people_margin, Unit::meter, between(0.0, 10.0),
        "distance kept from people");
  visit("patience", o.patience, Unit::second, kNotNegative,
        "waits this long for somebody in the way, then goes round");
}

// Follows a named path of the world as a careful operator would, who sees robot and people: slows
// down at corners, waits for people in the way, and where they stay goes round them if there is
// room, else backs up to let them pass. Looks at the simulation, not at measurements.
class ScriptedDriver : public Driver {
 public:
  ScriptedDriver(const Simulation& simulation, const NamedPath& path,
                 const ScriptedDriverOptions& options = {});

  void add(const Measurement& /*measurement*/) override {}
  DriveCommand command(double time) override;
  bool is_done() const override { return is_done_; }
  bool is_resting(double time) const override { return time < pause_until_; }

  double longest_time() const override;

 protected:
  // Towards a point, [m] in the world, no faster than `speed` [m/s].
  virtual DriveCommand steer(const Eigen::Vector2d& to, double speed);
  virtual DriveCommand back_up() const;  // away from somebody, as long as that is free

  const Simulation& simulation() const { return simulation_; }
  bool is_free_of_walls(const Eigen::Vector2d& to) const;
  bool is_free_of_people(const Eigen::Vector2d& to) const;
  double braking_speed() const;  // [m/s] from which it can stop at the next pause or the end

 private:
  // The point to steer for, on the path `look_ahead` further than the robot has come.
  Eigen::Vector2d target();
  Eigen::Vector2d way_round(const Eigen::Vector2d& to) const;
  DriveCommand give_way(const Eigen::Vector2d& aim, double time, double speed);
  double way_left() const;  // [m] to the next way-point that is a pause or the end

  const Simulation& simulation_;
  NamedPath path_;
  ScriptedDriverOptions options_;
  std::size_t leg_ = 1;          // on the way to this way-point
  double progress_ = 0.0;        // [m] along that leg
  double pause_until_ = -1.0;    // [s]
  double wait_since_ = -1.0;     // [s] somebody is in the way; -1: nobody
  double retreat_until_ = -1.0;  // [s]
  double asked_ = -1.0;          // [s] last decision
  DriveCommand last_;
  bool is_done_ = false;
};

}  // namespace mapbed
