#pragma once

#include <vector>

#include "core/config/option.h"
#include "core/driver.h"
#include "sim/drivers/car_path.h"
#include "sim/simulation.h"

namespace mapbed {

struct CarDriverOptions {
  double speed = 0.4;           // [m/s] where the path does not say
  double look_ahead = 0.4;      // [m] the point of the path that is steered for
  double margin = 0.12;         // [m] kept from walls
  double people_margin = 0.25;  // [m] kept from people
  double patience = 3.0;        // [s] waits for somebody in the way, then looks for a way round
};

template <class Visitor>
void visit_fields(CarDriverOptions& o, Visitor&& visit) {
  visit("speed", o.speed, Unit::meter_per_second, between(0.001, 100.0),
        "where the path does not say");
  visit("look_ahead", o.look_ahead, Unit::meter, between(0.01, 100.0),
        "how far ahead it steers for");
  visit("margin", o.margin, Unit::meter, between(0.0, 10.0), "distance kept from walls");
  visit("people_margin", o.people_margin, Unit::meter, between(0.0, 10.0),
        "distance kept from people");
  visit("patience", o.patience, Unit::second, kNotNegative,
        "waits this long for somebody in the way, then looks for a way round");
}

// Drives a car: plans, with its turning circle, from each way-point of a path to the next,
// backwards where there is no room to turn, and follows that by pure pursuit. Waits for people in
// the way, and where they stay plans anew around them. Throws InputError where the car cannot get
// along the path.
class CarDriver : public Driver {
 public:
  CarDriver(const Simulation& simulation, const NamedPath& path,
            const CarDriverOptions& options = {});

  void add(const Measurement& /*measurement*/) override {}
  DriveCommand command(double time) override;
  bool is_done() const override { return is_done_; }
  bool is_resting(double time) const override { return time < pause_until_; }
  double longest_time() const override;

 private:
  // From here to the path's end; the way-point to which there is no way, or one past the last.
  std::size_t plan(const Pose2& world_from_axle, std::span<const Obstacle> people);
  Pose2 axle() const;                  // world_from_axle, now
  std::size_t end_of_stretch() const;  // where it stops next: for a pause, or to change direction
  void follow_progress();
  bool is_free_of_people() const;
  DriveCommand pursue() const;
  double speed_to(std::size_t end, double curvature) const;
  DriveCommand give_way(double time);

  const Simulation& simulation_;
  NamedPath path_;
  CarDriverOptions options_;
  CarBody body_;
  std::vector<CarPathPoint> plan_;
  std::vector<std::size_t> ends_;  // in plan_, of the legs to each way-point
  std::size_t at_ = 0;             // in plan_: how far it has come
  std::size_t leg_ = 1;            // on the way to this way-point
  double length_ = 0.0;            // [m] of the plan in the beginning
  double pause_until_ = -1.0;      // [s]
  double wait_since_ = -1.0;       // [s] somebody is in the way; -1: nobody
  double asked_ = -1.0;            // [s] last decision
  DriveCommand last_;
  bool is_done_ = false;
};

}  // namespace mapbed
