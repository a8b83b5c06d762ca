#pragma once

#include <vector>

#include "core/driver.h"
#include "sim/drivers/car_path.h"
#include "sim/drivers/path_following.h"
#include "sim/simulation.h"

namespace mapbed {

struct CarDriverOptions : PathFollowingOptions {
  CarDriverOptions() { look_ahead = 0.4; }  // its arcs are tighter than a path's corners
};

// Drives a car: plans, with its turning circle, from each way-point of a path to the next,
// backwards where there is no room to turn, and follows that by pure pursuit. Waits for people in
// the way, and where they stay plans anew around them, else backs up to let them pass. Throws
// InputError where the car cannot get along the path.
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
  // From here to the present way-point, around people; whether there is a way.
  bool plan_anew(std::span<const Obstacle> people);
  void try_plan(double time, std::span<const Obstacle> people);  // not too often
  void plan_on(std::size_t end);  // to the way-points before this one, as far as there are ways
  void append(const std::vector<CarPathPoint>& way_to_next);
  void go_on_from_dead_end(double time);
  Pose2 axle() const;                  // world_from_axle, now
  std::size_t end_of_stretch() const;  // where it stops next: for a pause, or to change direction
  void follow_progress();
  bool is_free_of_people() const;
  DriveCommand pursue() const;
  double speed_to(std::size_t end, double curvature) const;
  DriveCommand give_way(double time);
  bool gets_on(double time);
  void make_room();

  const Simulation& simulation_;
  NamedPath path_;
  CarDriverOptions options_;
  CarBody body_;
  std::vector<CarPathPoint> plan_;  // from the start on
  std::vector<std::size_t> ends_;   // in plan_, of the legs to each way-point
  std::size_t at_ = 0;              // in plan_: how far it has come
  std::size_t leg_ = 1;             // on the way to this way-point
  std::size_t planned_ = 1;         // plan_ leads to the way-points before this one
  bool is_dead_end_ = false;        // ... and there is no way to this one from there
  std::size_t made_room_at_ = 0;    // in plan_: where it last made room
  Eigen::Vector2d got_to_ = Eigen::Vector2d::Zero();  // [m] where it last ...
  double got_on_at_ = 0.0;                            // [s] ... and when it had come some way
  double length_ = 0.0;                               // [m] of the plan in the beginning
  double pause_until_ = -1.0;                         // [s]
  double wait_since_ = -1.0;                          // [s] somebody is in the way; -1: nobody
  double asked_ = -1.0;                               // [s] last decision
  double plan_after_ = 0.0;                           // [s] next time that it may plan ...
  double plan_pause_ = 0.0;  // [s] ... and how long it waits after that if there is no way
  DriveCommand last_;
  bool is_done_ = false;
};

}  // namespace mapbed
