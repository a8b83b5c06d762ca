#pragma once

#include <memory>
#include <vector>

#include "core/config/option.h"
#include "core/driver.h"
#include "core/random.h"
#include "robots/robot.h"
#include "sim/actors/crowd.h"
#include "sim/actors/floor_plan.h"
#include "sim/truth.h"
#include "worlds/world.h"

namespace mapbed {

struct SimulationOptions {
  double step = 0.01;    // [s] of physics
  int sweep_slices = 4;  // moments of a sweep for which everything that moves is put in its place
  CrowdOptions people = {};
};

template <class Visitor>
void visit_fields(SimulationOptions& o, Visitor&& visit) {
  visit("step", o.step, Unit::second, between(0.001, 0.05), "of physics");
  visit("sweep_slices", o.sweep_slices, between(1, 100),
        "moments of a sweep at which everything that moves is put in its place");
  visit("people", o.people, "who is about");
}

// Everything that moves, at one moment.
struct Situation {
  double time = 0.0;  // [s] from the start
  Pose2 robot;        // world_from_robot
  Pose2 wheels;       // by the wheels' turns alone
  DriveCommand motors;
  std::vector<PersonView> people;
  std::vector<Pose2> leaves;  // world_from_leaf of the doors
  std::vector<bool> leaves_moving;
};

// A world with its robot, people and doors, going on in steps.
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
  const FloorPlan& floor_plan() const;  // for the robot
  const Situation& now() const;         // stays where it is in memory and changes with each step
  Situation at(double time) const;      // [s] within the last 200 ms or the longest sweep
  bool is_touching() const;             // the robot touches something

  // A whole sweep that began at `start` and is over by now, every beam at its own time and from its
  // own pose. Changes nothing but where the scene has its moving things.
  struct Sweep {
    IdealScan ideal;
    TruthScan truth;
  };
  Sweep sweep(int laser, double start, std::uint64_t number);

  std::vector<TruthEntity> entities() const;

 private:
  std::vector<std::vector<AimedBeam>> beams_by_slice(const LaserModel& laser, double start) const;

  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mapbed
