#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bench/results/result_file.h"
#include "bench/results/results.h"
#include "bench/results/series.h"
#include "bench/sources/run_input.h"
#include "core/config/configured.h"
#include "core/config/settings.h"

namespace mapbed {

struct RunOutcome {
  // By name; one that is left out has no value in this run.
  std::vector<std::pair<std::string, double>> values;
  std::string failure;               // in one line, for a run that did not come to what it should
  double method_seconds = 0.0;       // [s] of processor time of the method alone; 0: not told
  double method_wall_seconds = 0.0;  // [s] the same by the clock
  double program_seconds = 0.0;      // [s] of method_seconds, in programs of somebody else's
  double program_memory = 0.0;       // [bytes] of such a one at most
  std::vector<ResultFile> files;
  std::vector<Series> series;  // those of Experiment::series, where the run has them
};

// What a scenario's runs do. A new one is a file pair in this folder and a line in the table.
struct Experiment {
  // What the runs work on; each of these includes those before it.
  enum class Needs : int {
    nothing,  // no log at all: settings and chance alone
    log,      // measurements, of a recorded log or of a simulated one
    truth,    // and the true path
    world,    // and the world itself: its things, materials and true map
  };

  std::string name;
  std::string about;
  Needs needs = Needs::log;
  std::vector<Metric> metrics;
  // Settings become typed options, once for each level and variant; throws InputError. What comes
  // of it does a run.
  std::function<Configured<RunOutcome(const RunInput&)>(const Settings&)> configure;
  std::vector<SeriesMetric> series = {};  // what its runs give over iterations or time
  // Names of logs that a run needs besides the scenario's own: "mapping" for the drive that the map
  // is made of. A group of that name in the scenario says what differs in it.
  std::vector<std::string> further_logs = {};
};

// The words of Experiment::Needs: "nothing", "a log", …
std::string text_of(Experiment::Needs needs);

const std::vector<Experiment>& experiments();

// Throws InputError for an unknown name, which stands at `place`.
const Experiment& experiment_by_name(const std::string& name, const SourceLocation& place = {});

// One that has an options struct: `run` is called with the options and the input.
template <class Options>
Experiment make_experiment(const std::string& name, const std::string& about,
                           Experiment::Needs needs, std::vector<Metric> metrics,
                           RunOutcome (*run)(const Options&, const RunInput&)) {
  const auto configure = [name, run](const Settings& settings) {
    Options options;
    apply(settings, options_of(options), name);
    const std::string yaml = to_yaml(options_of(options));
    return Configured<RunOutcome(const RunInput&)>{
        yaml,
        [options = std::move(options), run](const RunInput& input) { return run(options, input); }};
  };
  return {name, about, needs, std::move(metrics), configure};
}

}  // namespace mapbed
