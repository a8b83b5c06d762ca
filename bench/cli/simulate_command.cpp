#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "bench/simulate.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

using Clock = std::chrono::steady_clock;

struct SimulateArguments {
  std::string scenario;
  std::string world;
  std::string robot;
  std::string path;
  std::string log;
  int people = -1;
  std::uint64_t seed = 0;
  bool has_seed = false;
  std::vector<std::string> settings;
};

SimulationPlan plan_of(const SimulateArguments& a) {
  SimulationPlan plan;
  if (!a.scenario.empty()) plan = load_simulation_plan(a.scenario);
  if (!a.world.empty()) plan.world = a.world;
  if (!a.robot.empty()) plan.robot = a.robot;
  if (!a.path.empty()) plan.path = a.path;
  if (a.people >= 0) plan.people = a.people;
  if (a.has_seed) plan.seed = a.seed;
  for (const std::string& text : a.settings) plan.settings.push_back(parse_setting(text));
  if (plan.world.empty() || plan.robot.empty()) {
    throw InputError("simulate needs a scenario file, or --world and --robot");
  }
  return plan;
}

int simulate(const SimulateArguments& arguments) {
  const SimulationPlan plan = plan_of(arguments);
  const Clock::time_point start = Clock::now();
  const SimulationResult result = run_simulation(plan);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  write_simulation(arguments.log, result);

  const auto& scans = result.recording.scans;
  const Trajectory truth = trajectory_of(result.recording.truth);
  const double recorded = scans.empty() ? 0.0 : scans.back().time - scans.front().time;
  fmt::print(
      "{} in {}: {} scans, {:.1f} s, {:.1f} m of path; simulated in {:.2f} s, {:.0f} times "
      "real time\n",
      result.robot.name, result.world.name, scans.size(), recorded, path_length(truth), seconds,
      seconds > 0.0 ? recorded / seconds : 0.0);
  if (!result.recording.is_complete) {
    fmt::print(stderr, "remark: the robot did not get to the end of its path in time\n");
  }
  fmt::print("written to {} and files beside it\n", arguments.log);
  return kDone;
}

}  // namespace

void add_simulate_command(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand(
      "simulate",
      "Record a log in a simulated world, with truth, relations and true map beside it");
  const auto a = std::make_shared<SimulateArguments>();
  command->add_option("SCENARIO", a->scenario, "a scenario file (YAML)");
  command->add_option("--world", a->world, "a world's name or file");
  command->add_option("--robot", a->robot, "a robot's name or file");
  command->add_option("--path", a->path, "a named path of the world; its first where left out");
  command->add_option("--people", a->people, "how many walk about; as the world says if left out")
      ->check(CLI::NonNegativeNumber);
  CLI::Option* seed = command->add_option("--seed", a->seed, "of everything that is chance");
  command->add_option("--set", a->settings,
                      "any option: world.…, robot.…, simulation.…, driver.…, recorder.…=value");
  command->add_option("-o,--out", a->log, "the CARMEN log to write; .gz: compressed")->required();
  command->callback([a, seed, &action] {
    a->has_seed = seed->count() > 0;
    action = [a] { return simulate(*a); };
  });
}

}  // namespace mapbed
