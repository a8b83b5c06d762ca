#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "bench/metrics/relations.h"
#include "bench/results/result_file.h"
#include "bench/results/results.h"
#include "bench/results/series.h"
#include "core/config/settings.h"
#include "core/geometry/trajectory.h"
#include "core/log/sensor_log.h"
#include "core/random.h"
#include "sim/recorder.h"
#include "worlds/geometry/raster.h"

namespace mapbed {

// What a run works on. Only metrics may look beyond the log.
struct RunInput {
  SensorLog log;                         // empty where the experiment needs none
  Trajectory truth;                      // world_from_robot, by time; empty: nobody knows
  const Recording* recording = nullptr;  // null for a recorded log
  const World* world = nullptr;          // the same
  // The world's true map with cells of this size [m]; none for a recorded log.
  std::function<const TrueMap&(double resolution)> true_map = {};
  // How the robot truly moved between pairs of stamps; none where nobody measured that.
  std::function<const MeasuredRelations&()> relations = {};
  Rng rng{0};
  std::set<std::string> wanted;  // metrics; others need not be worked out
  bool shown = false;            // pictures of this run are wanted too
  // Which run it is, for them: "raw, people = 5"; empty: seeds alone set the runs apart.
  std::string label = {};
};

// Without what comes later than `longest` [s] after the log's start; 0: all of it.
RunInput shortened(RunInput input, double longest);

struct RunOutcome {
  // By name; one that is left out has no value in this run.
  std::vector<std::pair<std::string, double>> values;
  std::string failure;          // in one line, for a run that did not come to what it should
  double method_seconds = 0.0;  // [s] of processor time of the method alone; 0: not told
  std::vector<ResultFile> files;
  std::vector<Series> series;  // those of Experiment::series, where the run has them
};

// What a scenario's runs do. A new one is a file in this folder and a line in the table.
struct Experiment {
  std::string name;
  std::string about;
  bool needs_log = true;
  std::vector<Metric> metrics;
  // Applies settings to the options, which it gives back in full; throws InputError.
  std::function<std::string(const Settings&)> complete_yaml;
  std::function<RunOutcome(const Settings&, const RunInput&)> run;
  std::vector<SeriesMetric> series = {};  // what its runs give over iterations or time
};

const std::vector<Experiment>& experiments();

// Throws InputError for an unknown name, which stands at `place`.
const Experiment& experiment_by_name(const std::string& name, const SourceLocation& place = {});

// One that has an options struct: `run` is called with the options and the input.
template <class Options>
Experiment make_experiment(const std::string& name, const std::string& about, bool needs_log,
                           std::vector<Metric> metrics,
                           RunOutcome (*run)(const Options&, const RunInput&)) {
  const auto options_from = [name](const Settings& settings) {
    Options options;
    apply(settings, options_of(options), name);
    return options;
  };
  return {name,
          about,
          needs_log,
          std::move(metrics),
          [options_from](const Settings& settings) {
            Options options = options_from(settings);
            return to_yaml(options_of(options));
          },
          [options_from, run](const Settings& settings, const RunInput& input) {
            return run(options_from(settings), input);
          }};
}

}  // namespace mapbed
