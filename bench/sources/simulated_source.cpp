#include "bench/sources/simulated_source.h"

#include <map>
#include <mutex>
#include <optional>

#include "sim/noise/sensor_noise.h"
#include "sim/relations.h"

namespace mapbed {
namespace {

class SimulatedSource : public LogSource {
 public:
  SimulatedSource(const PreparedSimulation& simulation, std::uint64_t seed, const GoesOn& goes_on)
      : simulation_(simulation),
        recording_(record(simulation, seed, goes_on)),
        truth_(trajectory_of(recording_.truth)) {}

  double recorded_seconds() const override {
    return truth_.empty() ? 0.0 : truth_.back().time - truth_.front().time;
  }

  std::string remark() const override { return recording_.end.stuck; }

 private:
  LogInput clean_input(const SourcePlan& plan, std::uint64_t seed) const override {
    LogInput input;
    const Robot& robot = std::get<PreparedSimulation>(plan.origin).robot;
    input.log = with_noise(recording_.readings, robot, Rng(seed));
    input.truth = truth_;
    input.recording = &recording_;
    input.world = simulation_.world.get();
    input.true_map = [this](double resolution) -> const TrueMap& { return true_map(resolution); };
    input.relations = [this]() -> const MeasuredRelations& { return relations(); };
    return input;
  }

  const TrueMap& true_map(double resolution) const {
    const std::scoped_lock lock(mutex_);
    const auto found = true_maps_.find(resolution);
    if (found != true_maps_.end()) return found->second;
    RasterOptions options{.resolution = resolution};
    options.height = lasers_of(simulation_.robot).front().robot_from_laser.z;
    return true_maps_.emplace(resolution, raster(*simulation_.world, options)).first->second;
  }

  // Those that `mapbed simulate` writes beside a log.
  const MeasuredRelations& relations() const {
    const std::scoped_lock lock(mutex_);
    if (!relations_) {
      const std::string text = relations_text(truth_);
      relations_.emplace();
      if (!text.empty()) relations_->relations = parse_relations("true relations", text);
    }
    return *relations_;
  }

  const PreparedSimulation& simulation_;
  Recording recording_;
  Trajectory truth_;
  mutable std::mutex mutex_;
  mutable std::optional<MeasuredRelations> relations_;
  mutable std::map<double, TrueMap> true_maps_;  // by resolution; references stay valid
};

}  // namespace

SourcePlan plan_simulated(const Settings& settings, SimulationParts& parts) {
  PreparedSimulation simulation = prepare_simulation(simulation_plan(settings), parts);
  SourcePlan plan{.complete_yaml = simulation.config + simulation.faults.complete_yaml,
                  .clean_yaml = simulation.config,
                  .key = simulation.noiseless_config,
                  .faults = simulation.faults};
  plan.files = simulation.files;
  plan.origin = std::move(simulation);
  return plan;
}

std::unique_ptr<LogSource> open_simulated(const PreparedSimulation& simulation, std::uint64_t seed,
                                          const GoesOn& goes_on) {
  return std::make_unique<SimulatedSource>(simulation, seed, goes_on);
}

}  // namespace mapbed
