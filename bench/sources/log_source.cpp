#include "bench/sources/log_source.h"

#include <fmt/format.h>

#include "bench/sources/recorded_source.h"
#include "bench/sources/simulated_source.h"
#include "bench/sources/source_settings.h"
#include "core/config/config_node.h"
#include "core/input_error.h"

namespace mapbed {

SourcePlan plan_source(const Settings& settings, SourceParts& parts) {
  const bool is_recorded = last_named(settings, "log") != nullptr;
  return is_recorded ? plan_recorded(settings, parts.files)
                     : plan_simulated(settings, parts.simulation);
}

LogInput LogSource::input(const SourcePlan& plan, std::uint64_t seed) const {
  LogInput input = clean_input(plan, seed);
  input.shared = &shared_.of(fmt::format("{}\n{}", seed, plan.clean_yaml));
  if (plan.faults.planned.empty()) return input;
  input.clean = input.log;
  FaultyLog faulty = broken(std::move(input.log), input.truth, plan.faults, Rng(seed));
  input.log = std::move(faulty.log);
  input.faults = std::move(faulty.faults);
  return input;
}

bool has_truth(const SourcePlan& plan) {
  return plan.is_simulated() || tells_truth(std::get<RecordedPlan>(plan.origin));
}

std::unique_ptr<LogSource> open_source(const SourcePlan& plan, std::uint64_t seed,
                                       const GoesOn& goes_on) {
  if (!plan.is_simulated()) return open_recorded(std::get<RecordedPlan>(plan.origin), goes_on);
  return open_simulated(std::get<PreparedSimulation>(plan.origin), seed, goes_on);
}

SimulationPlan simulation_plan(const Settings& settings) {
  SimulationPlan plan;
  for (const Setting& setting : settings) {
    if (setting.path == "world") {
      plan.world = setting.text;
    } else if (setting.path == "robot") {
      plan.robot = setting.text;
    } else if (setting.path == "path") {
      plan.path = setting.text;
    } else if (setting.path == "driver") {
      plan.driver = setting.text;
    } else if (setting.path == "people") {
      plan.people = ConfigNode(setting.text, setting.place).whole_number(between(0, 5000));
    } else {
      plan.settings.push_back(setting);
    }
  }
  if (plan.world.empty() || plan.robot.empty()) {
    const SourceLocation place = settings.empty() ? SourceLocation{} : settings.back().place;
    throw InputError({place.file, 0}, "there is no log to work on",
                     "give 'world' and 'robot' for a simulated one, or 'log' for a recorded one");
  }
  return plan;
}

}  // namespace mapbed
