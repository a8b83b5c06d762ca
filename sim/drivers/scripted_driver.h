#pragma once

#include "core/driver.h"
#include "sim/drivers/path_following.h"
#include "sim/simulation.h"

namespace mapbed {

// Follows a named path of the world as a careful operator would, who sees robot and people: slows
// down at corners, waits for people in the way, and where they stay goes round them if there is
// room, else backs up to let them pass. Looks at the simulation, not at measurements.
class ScriptedDriver : public Driver {
 public:
  ScriptedDriver(const Simulation& simulation, const NamedPath& path,
                 const PathFollowingOptions& options = {});

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
  PathFollowingOptions options_;
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
