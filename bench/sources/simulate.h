#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "bench/faults/faults.h"
#include "core/config/configured.h"
#include "core/config/settings.h"
#include "core/interrupted.h"
#include "core/log/sensor_log.h"
#include "sim/drivers/drivers.h"
#include "sim/recorder.h"
#include "sim/simulation.h"

namespace mapbed {

// Which world, which robot along which path, who is about.
struct SimulationPlan {
  std::string world;   // a builder's name or a world file
  std::string robot;   // a robot's name or file
  std::string path;    // a named path of the world; empty: its first
  std::string driver;  // a driver by name; empty: the first of driver_kinds()
  int people = -1;     // all together, see with_people(); -1: as many as the world says
  Settings settings;   // world.…, robot.…, simulation.…, driver.…, recorder.…, faults.…
};

// Worlds and robots for simulations that are prepared together: each is read or built once, however
// many of them it is in.
class SimulationParts {
 public:
  struct BuiltWorld {
    std::string complete_yaml;
    std::shared_ptr<const World> world;
    InputFiles files;
  };
  const BuiltWorld& world(const std::string& name, const Settings& settings);
  const Robot& robot(const std::string& name);  // as its file has it

 private:
  std::map<std::string, BuiltWorld> worlds_;  // by name and what is set of it
  std::map<std::string, Robot> robots_;
};

// A simulation whose settings are bound: nothing is read from text or disk any more.
struct PreparedSimulation {
  std::shared_ptr<const World> world;
  Robot robot;
  NamedPath path;
  SimulationOptions simulation;
  std::function<MakeDriver> make_driver;
  RecorderOptions recorder;
  PlannedFaults faults;          // that are put into its log in the end; not in the texts below
  InputFiles files;              // of world and robot
  std::string config;            // complete: as a scenario file it gives the same again
  std::string noiseless_config;  // the same without what is drawn after recording: plans that agree
                                 // in this and in the seed give the same recording
};

// Throws InputError where something is unknown or does not fit.
PreparedSimulation prepare_simulation(const SimulationPlan& plan, SimulationParts& parts);
PreparedSimulation prepare_simulation(const SimulationPlan& plan);

// `seed` is that of everything that is chance. For several threads at a time. The log is what the
// prepared robot reads: with_noise(recording.readings, prepared.robot, Rng(seed)).
// Throws Interrupted where it is not to go on.
Recording record(const PreparedSimulation& prepared, std::uint64_t seed,
                 const GoesOn& goes_on = {});

struct SimulationResult {
  PreparedSimulation simulation;
  std::uint64_t seed = 0;
  Recording recording;
  SensorLog log;
};

// All of the above, noise and faults.
SimulationResult run_simulation(PreparedSimulation simulation, std::uint64_t seed);
SimulationResult run_simulation(const SimulationPlan& plan, std::uint64_t seed);

}  // namespace mapbed
