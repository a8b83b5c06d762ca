#include "bench/experiments/log_faults.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/input/input_stage.h"
#include "bench/methods/method_run.h"
#include "bench/metrics/pairs.h"
#include "bench/process/process_cost.h"
#include "bench/sources/shared_work.h"

namespace mapbed {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct LogFaultsOptions {
  std::string estimator = "scan_matching";
  InputOptions input;
  double allowed_times = 2.0;
  double allowed_more = 0.05;  // [m]
  double told_within = 2.0;    // [s]
};

template <class Visitor>
void visit_fields(LogFaultsOptions& o, Visitor&& visit) {
  visit("estimator", o.estimator, "who finds the trajectory; 'mapbed list methods'");
  visit("input", o.input, "how what sensors tell is prepared for the method");
  visit("allowed_times", o.allowed_times, between(1.0, 1000.0),
        "the error of a robust method is at most this times that in the clean log");
  visit("allowed_more", o.allowed_more, Unit::meter, kNotNegative, "and so much more");
  visit("told_within", o.told_within, Unit::second, kNotNegative,
        "a remark that names a fault is about a time at most this far from it");
}

struct Setup {
  LogFaultsOptions options;
  ChosenMethod method;
  ChosenMethod odometry;
  std::string method_yaml;
  std::string clean_yaml;  // what decides what is made of a log
};

Setup setup_of(const Settings& settings) {
  const MethodSettings divided = divided_by_method(settings);
  Setup setup;
  apply(divided.own, options_of(setup.options), "log_faults");
  setup.method = chosen_method(setup.options.estimator, divided);
  setup.odometry = chosen_method("odometry", divided);
  setup.method_yaml = method_yaml(setup.method);
  setup.clean_yaml = to_yaml(options_of(setup.options.input)) + setup.method_yaml;
  return setup;
}

// Of the log as it is prepared for methods, with what is remarked on then.
MethodRun prepared_run(const Setup& setup, const SensorLog& log, const RunInput& input) {
  const PreparedLog prepared = mapbed::prepared(log, setup.options.input);
  MethodRun run = run_method(setup.method, {.as_recorded = log,
                                            .prepared = prepared.log,
                                            .rng = input.rng.stream("estimator"),
                                            .seed = input.seed,
                                            .goes_on = input.goes_on});
  // A program got the log as it is; what is told of it here is none of its words.
  if (setup.method.program() == nullptr) add_remarks_on_input(prepared, run.estimate);
  return run;
}

// What a method makes of the log without faults.
struct CleanRun {
  Estimate estimate;
  MeasuredRelations relations;  // where the log has none: its own pairs
  double error = kNone;         // [m]
};

const MeasuredRelations& relations_of(const RunInput& input, const CleanRun& clean) {
  return input.relations ? input.relations() : clean.relations;
}

// [m] mean translational error; NaN where nothing can be compared.
double error_of(const Estimate& estimate, const MeasuredRelations& relations) {
  if (estimate.trajectory.empty()) return kNone;
  return relations_error(estimate.trajectory, relations.relations, relations.odometry)
      .mean_translation;
}

const SensorLog& clean_log_of(const RunInput& input) {
  return input.faults.empty() ? input.log : input.clean;
}

CleanRun clean_run(const Setup& setup, const RunInput& input) {
  CleanRun clean;
  clean.estimate = prepared_run(setup, clean_log_of(input), input).estimate;
  if (!input.relations) {
    clean.relations.relations = input.pairs ? input.pairs() : pairs_of(clean.estimate.trajectory);
  }
  clean.error = error_of(clean.estimate, relations_of(input, clean));
  return clean;
}

bool is_alarm(const Remark& remark) {
  return std::any_of(faults().begin(), faults().end(), [&remark](const Fault& fault) {
    return std::find(fault.told_as.begin(), fault.told_as.end(), remark.kind) !=
           fault.told_as.end();
  });
}

bool is_near(const TimeInterval& a, const TimeInterval& b, double within) {
  return a.from <= b.to + within && b.from <= a.to + within;
}

bool tells(const Remark& remark, const FaultInLog& fault, double within) {
  const auto& kinds = fault.told_as;
  if (std::find(kinds.begin(), kinds.end(), remark.kind) == kinds.end()) return false;
  return !remark.when || std::any_of(fault.when.begin(), fault.when.end(), [&](const auto& when) {
    return is_near(*remark.when, when, within);
  });
}

double odometry_error_of(const Setup& setup, const RunInput& input,
                         const MeasuredRelations& relations) {
  const MethodRun run = run_method(
      setup.odometry,
      {.as_recorded = input.log, .prepared = input.log, .rng = input.rng.stream("odometry")});
  return error_of(run.estimate, relations);
}

RunOutcome run(const Setup& setup, const RunInput& input) {
  const LogFaultsOptions& options = setup.options;
  const std::string key = std::to_string(Rng(input.rng).bits()) + "\n" + setup.clean_yaml;
  const auto& clean = input.shared->once<CleanRun>(key, [&] { return clean_run(setup, input); });
  const bool is_clean = input.faults.empty();
  const double start = processor_time();
  const MethodRun broken =
      is_clean ? MethodRun{clean.estimate, {}} : prepared_run(setup, input.log, input);
  const Estimate& estimate = broken.estimate;
  const double in_program = setup.method.program() == nullptr ? 0.0 : broken.cost.processor_seconds;
  const double seconds = processor_time() - start + in_program;

  const MeasuredRelations& relations = relations_of(input, clean);
  const double error = error_of(estimate, relations);
  const double odometry = odometry_error_of(setup, input, relations);
  const double told = told_faults(input.faults, estimate.remarks, options.told_within);
  const bool is_compared = !std::isnan(error) || estimate.trajectory.empty();
  const bool is_kept = error <= options.allowed_times * clean.error + options.allowed_more &&
                       error <= std::max(odometry, clean.error);
  // Of a fault that found no place there is nothing to be seen.
  const bool is_seen = (is_clean || !std::isnan(told)) && clean.error > 0.0;
  const double ratio = is_seen ? error / clean.error : kNone;
  const double kept = is_compared ? static_cast<double>(is_kept) : kNone;
  const auto alarms = std::count_if(estimate.remarks.begin(), estimate.remarks.end(), is_alarm);
  RunOutcome outcome;
  outcome.method_seconds = is_clean ? 0.0 : seconds;
  outcome.method_wall_seconds = broken.cost.wall_seconds;
  outcome.program_seconds = in_program;
  outcome.program_memory = broken.cost.peak_memory;
  outcome.values = {{"error", error},
                    {"clean_error", clean.error},
                    {"error_ratio", ratio},
                    {"odometry_error", odometry},
                    {"told", told},
                    {"kept", kept},
                    {"kept_or_told", told == 1.0 ? 1.0 : kept},
                    {"alarms", static_cast<double>(alarms)}};
  return outcome;
}

std::vector<Metric> metrics() {
  return {
      {"error", Unit::meter, "mean error over the relations, in the broken log"},
      {"clean_error", Unit::meter, "the same in the log without faults"},
      {"error_ratio", Unit::none, "error over clean_error; none where no fault found a place"},
      {"odometry_error", Unit::meter, "error of the broken log's odometry alone"},
      {"told", Unit::none,
       "fraction of the faults that a remark of the right kind names, at the right time", 0.0},
      {"kept", Unit::none,
       "1: error is at most allowed_times clean_error + allowed_more, and at most the larger of "
       "odometry_error and clean_error",
       0.0},
      {"kept_or_told", Unit::none, "1: kept, or all faults are told", 0.0},
      {"alarms", Unit::none, "remarks that name some fault, right or not"},
  };
}

}  // namespace

double told_faults(const std::vector<FaultInLog>& faults, const std::vector<Remark>& remarks,
                   double within) {
  int present = 0;
  int told = 0;
  for (const FaultInLog& fault : faults) {
    if (fault.when.empty()) continue;
    ++present;
    const bool is_told = std::any_of(remarks.begin(), remarks.end(), [&](const Remark& remark) {
      return tells(remark, fault, within);
    });
    told += is_told ? 1 : 0;
  }
  return present == 0 ? kNone : static_cast<double>(told) / present;
}

Experiment log_faults_experiment() {
  const auto configure = [](const Settings& settings) {
    Setup setup = setup_of(settings);
    const std::string yaml = to_yaml(options_of(setup.options)) + setup.method_yaml;
    InputFiles files = setup.method.files;
    return Configured<RunOutcome(const RunInput&)>{
        yaml, [setup = std::move(setup)](const RunInput& input) { return run(setup, input); },
        std::move(files)};
  };
  return {.name = "log_faults",
          .about = "a method finds the trajectory in a log that was broken on purpose",
          .needs = Experiment::Needs::log,
          .metrics = metrics(),
          .configure = configure};
}

}  // namespace mapbed
