#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/config/option.h"
#include "core/driver.h"
#include "core/random.h"
#include "robots/robot.h"
#include "sim/actors/actors.h"
#include "sim/actors/navigation_map.h"
#include "sim/physics/touch.h"
#include "sim/sensors/ideal_rfid.h"
#include "sim/sensors/ideal_scan.h"
#include "sim/truth/truth.h"
#include "worlds/world.h"

namespace mapbed {

struct SimulationOptions {
  double step = 0.01;    // [s] of physics
  int sweep_slices = 4;  // moments of a sweep for which everything that moves is put in its place
  ActorOptions actors = {};
};

template <class Visitor>
void visit_fields(SimulationOptions& o, Visitor&& visit) {
  visit("step", o.step, Unit::second, between(0.001, 0.05), "of physics");
  visit("sweep_slices", o.sweep_slices, between(1, 100),
        "moments of a sweep at which everything that moves is put in its place");
  visit_fields(o.actors, visit);
}

// Everything that moves, at one moment.
struct Situation {
  double time = 0.0;  // [s] from the start
  Pose2 robot;        // world_from_robot
  Pose2 wheels;       // by the wheels' turns alone
  DriveCommand motors;
  std::vector<MovingPose> moving;  // all parts of all groups; the same ones at every moment
};

// A world with its robot and all that moves by itself, going on in steps.
class Simulation {
 public:
  // Throws InputError where the robot does not fit where it starts, or the people do not.
  Simulation(const World& world, const Robot& robot, const Pose2& start,
             const SimulationOptions& options, const Rng& rng);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  void step(const DriveCommand& command);

  const World& world() const;
  const Robot& robot() const;
  const NavigationMap& navigation_map() const;  // for the robot
  const Situation& now() const;                 // stays in its place and changes with each step
  std::span<const Obstacle> obstacles() const;  // that move, without the robot, as they stand now
  Situation at(double time) const;              // [s] within the last 200 ms or the longest sweep
  std::optional<Touch> touched() const;         // by the robot; the mover is one of obstacles()
  bool is_touching() const { return touched().has_value(); }

  // A whole sweep that began at `start` and is over by now, every beam at its own time and from its
  // own pose. `laser` as LaserScan counts. Changes nothing but where the scene has its moving
  // things.
  struct Sweep {
    IdealScan ideal;
    BeamTruthOfScan truth;
  };
  Sweep sweep(int laser, double start, std::uint64_t number);

  // An inventory round at a moment within the last 200 ms, whole at once. `antenna` as
  // RfidDetections counts. Changes nothing either.
  IdealRfid rfid_round(int antenna, double time, std::uint64_t number);

  const Entity& entity(int id) const;  // of the world or of who moves, as it was in the beginning
  TruthHeader truth_header() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mapbed
