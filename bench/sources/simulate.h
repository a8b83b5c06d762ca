#pragma once

#include <cstdint>
#include <string>

#include "core/config/settings.h"
#include "sim/recorder.h"
#include "sim/scripted_driver.h"
#include "sim/simulation.h"

namespace mapbed {

// One recording: which world, which robot along which path, who is about.
struct SimulationPlan {
  std::string world;       // a builder's name or a world file
  std::string robot;       // a robot's name or file
  std::string path;        // a named path of the world; empty: its first
  int people = -1;         // all together, see with_people(); -1: as many as the world says
  std::uint64_t seed = 1;  // of everything that is chance
  Settings settings;       // world.…, robot.…, simulation.…, driver.…, recorder.…
};

// Everything that is needed to record, checked.
struct PreparedSimulation {
  SimulationPlan plan;
  World world;
  Robot robot;
  NamedPath path;
  SimulationOptions simulation;
  ScriptedDriverOptions driver;
  RecorderOptions recorder;
  std::string config;            // complete, as YAML
  std::string noiseless_config;  // the same without what is drawn after recording: plans that agree
                                 // in this and in the seed give the same recording
};

// Throws InputError where something is unknown or does not fit.
PreparedSimulation prepare_simulation(const SimulationPlan& plan);
Recording record(const PreparedSimulation& prepared);
Robot robot_with_noise(const SimulationPlan& plan);  // the robot alone, with its settings

struct SimulationResult {
  World world;
  Robot robot;
  Recording recording;
  SensorLog log;
  std::string config;  // complete, as YAML
};

// All of the above, and noise.
SimulationResult run_simulation(const SimulationPlan& plan);

// Beside LOG = name.log[.gz]: name.truth.gz, name.relations, name.tum (true poses), name_map.pgm
// and .yaml (true map at the first laser's height), name.config.yaml.
void write_simulation(const std::string& log_path, const SimulationResult& result);

}  // namespace mapbed
