#include "bench/cli/render/run_to_film.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "algorithms/input/geometry_check.h"
#include "bench/cli/map_config.h"
#include "bench/cli/map_run.h"
#include "bench/cli/progress.h"
#include "bench/methods/method_run.h"
#include "bench/process/thread_limit.h"
#include "bench/scenario/run_scenario.h"
#include "bench/scenario/runner.h"
#include "bench/sources/chosen_log.h"
#include "core/config/suggestion.h"
#include "core/file/csv_file.h"
#include "core/file/text_file.h"
#include "core/input_error.h"
#include "core/log/log_file.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

// What `mapbed map` did.
class MapToFilm : public RunToFilm {
 public:
  explicit MapToFilm(const std::string& folder)
      : log_(log_of_map(folder)),
        config_(map_config_from(load_settings((fs::path(folder) / "config.yaml").string()))) {}

  std::string words() const override { return config_.chosen.name + " on " + log_; }

  void record(RunViewer& viewer, const GoesOn& goes_on) const override {
    RecordedLog log =
        while_told("reading", [&] { return load_log(chosen_log(log_).path, config_.log); });
    choose_geometry(log);
    const bool by_program = config_.chosen.program() != nullptr;
    const SensorLog as_recorded = by_program ? log.measurements : SensorLog{};
    RunInput input;
    input.log = prepared(std::move(log.measurements), config_.input).log;
    viewer.begins(input, config_.chosen.name);
    MethodWatch watch;
    watch.after = [&](const Measurement& measurement, const Estimator& estimator) {
      viewer.after(measurement, estimator);
    };
    const MethodRun run = run_method(config_.chosen,
                                     {.as_recorded = as_recorded,
                                      .prepared = input.log,
                                      .rng = Rng(config_.seed).stream(config_.method),
                                      .seed = config_.seed,
                                      .goes_on = goes_on},
                                     watch);
    viewer.ends(run.estimate);
  }

 private:
  std::string log_;
  MapConfig config_;
};

std::shared_ptr<const ScenarioPlan> plan_of(const std::string& scenario) {
  return while_told("planning", [&] {
    return std::make_shared<const ScenarioPlan>(make_plan(load_scenario(scenario)));
  });
}

class ScenarioRunToFilm : public RunToFilm {
 public:
  ScenarioRunToFilm(std::shared_ptr<const ScenarioPlan> plan, std::optional<int> number)
      : plan_(std::move(plan)) {
    const std::vector<int> to_do = plan_->runs_to_do();
    number_ = number.value_or(to_do.empty() ? 0 : to_do.front());
    if (number_ < 0 || number_ >= plan_->runs()) {
      throw InputError(
          fmt::format("there is no run {}; this scenario has 0 to {}", number_, plan_->runs() - 1));
    }
    const std::string missing = plan_->planned_of(plan_->row(number_)).missing();
    if (!missing.empty()) {
      throw InputError(missing + "; set MAPBED_DATA to the folder that holds it");
    }
  }

  int number() const { return number_; }
  std::string words() const override {
    return fmt::format("run {} of {}", number_, plan_->results.id);
  }

  void record(RunViewer& viewer, const GoesOn& goes_on) const override {
    const RunResult run = repeat_run(
        *plan_, number_, {.threads = processors(), .viewer = &viewer, .goes_on = goes_on});
    if (viewer.is_complete()) return;
    if (!run.row.failure.empty()) throw InputError(words() + " failed: " + run.row.failure);
    throw InputError(
        fmt::format("the experiment {} shows no method at work; films and figures are made of runs "
                    "of slam",
                    in_quotes(plan_->results.experiment)));
  }

 private:
  std::shared_ptr<const ScenarioPlan> plan_;
  int number_ = 0;
};

// Of a folder that `mapbed run --run N --out FOLDER` has written.
std::optional<int> number_in(const fs::path& row) {
  if (!fs::exists(row)) return {};
  const std::vector<CsvRow> rows = parse_csv(row.string(), read_text_file(row.string()));
  const double number = rows.size() == 2 && rows[0].front() == "run"
                            ? parse_csv_number(rows[1].front())
                            : std::numeric_limits<double>::quiet_NaN();
  if (!(number >= 0.0 && number < 1e9)) {
    throw InputError({row.string()}, "does not say which run it is of", "--run says it, too");
  }
  return static_cast<int>(number);
}

// What names a scenario, and which of its runs.
struct NamedRun {
  std::string scenario;
  std::optional<int> number;
};

// None: the folder holds the map of a log.
std::optional<NamedRun> scenario_run(const std::string& run, std::optional<int> number) {
  if (!fs::is_directory(run)) return NamedRun{run, number};
  const fs::path config = fs::path(run) / "config.yaml";
  if (!fs::exists(config)) {
    throw InputError({run}, "holds no run: there is no config.yaml in it",
                     "name a folder that 'mapbed map' or 'mapbed run' has written");
  }
  if (!log_of_map(run).empty()) return {};
  if (!number) number = number_in(fs::path(run) / "run.csv");
  return NamedRun{config.string(), number};
}

// The variants of these names, all where there are none.
std::vector<int> variants_of(const Results& results, const std::vector<std::string>& names) {
  std::vector<int> chosen;
  for (const std::string& name : names) {
    const auto found = std::find(results.variants.begin(), results.variants.end(), name);
    if (found == results.variants.end()) {
      throw InputError({"--variant"}, results.id + " has no variant " + in_quotes(name),
                       suggestion(name, results.variants));
    }
    chosen.push_back(static_cast<int>(found - results.variants.begin()));
  }
  for (int i = 0; names.empty() && i < static_cast<int>(results.variants.size()); ++i) {
    chosen.push_back(i);
  }
  return chosen;
}

}  // namespace

std::unique_ptr<RunToFilm> run_to_film(const std::string& run, std::optional<int> number) {
  const std::optional<NamedRun> named = scenario_run(run, number);
  if (named) return std::make_unique<ScenarioRunToFilm>(plan_of(named->scenario), named->number);
  if (number) throw InputError("--run chooses one of a scenario's runs; a map is of one alone");
  return std::make_unique<MapToFilm>(run);
}

std::vector<VariantRun> runs_of_variants(const std::string& run, std::optional<int> number,
                                         const std::vector<std::string>& variants) {
  const std::optional<NamedRun> named = scenario_run(run, number);
  if (!named) {
    throw InputError({run}, "holds one map, and no variants of a scenario",
                     "several maps are drawn together where their folders are named");
  }
  const auto plan = plan_of(named->scenario);
  const int chosen = ScenarioRunToFilm(plan, named->number).number();
  const int first = chosen - plan->row(chosen).variant;  // variants are the fastest to change
  std::vector<VariantRun> runs;
  for (const int variant : variants_of(plan->results, variants)) {
    runs.push_back({plan->results.variants[static_cast<std::size_t>(variant)],
                    std::make_unique<ScenarioRunToFilm>(plan, first + variant)});
  }
  return runs;
}

}  // namespace mapbed
