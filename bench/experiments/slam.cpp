#include "bench/experiments/slam.h"

#include <algorithm>

#include "algorithms/grid/map_file.h"
#include "algorithms/grid/wall_map.h"
#include "algorithms/input/input_stage.h"
#include "algorithms/pose_graph/graph_file.h"
#include "bench/experiments/moving_evaluator.h"
#include "bench/experiments/particle_figures.h"
#include "bench/experiments/slam_evaluator.h"
#include "bench/experiments/slam_series.h"
#include "bench/figures/association_figure.h"
#include "bench/figures/people_figures.h"
#include "bench/figures/revision_figures.h"
#include "bench/methods/method_run.h"
#include "bench/methods/people_filter.h"
#include "bench/plot/map_picture.h"
#include "bench/results/association_file.h"
#include "bench/results/replay.h"
#include "bench/sources/run_viewer.h"
#include "core/geometry/tum_file.h"
#include "core/image/png.h"
#include "sim/recording.h"

namespace mapbed {
namespace {

struct SlamOptions {
  std::string estimator = "scan_matching";
  InputOptions input;
  double longest = 0.0;           // [s]
  std::vector<double> snapshots;  // [s]
  std::vector<std::string> people_figures;
  double series_step = 10.0;  // [s]
  EvaluationOptions evaluation;
  TrackingMetricOptions tracking;
};

template <class Visitor>
void visit_fields(SlamOptions& o, Visitor&& visit) {
  visit("estimator", o.estimator, "who finds the trajectory; 'mapbed list methods'");
  visit("input", o.input, "how what sensors tell is prepared for the method");
  visit("longest", o.longest, Unit::second, kNotNegative,
        "of the log, what comes later is left out; 0: all of it counts");
  visit("snapshots", o.snapshots, Unit::second, kNotNegative,
        "since the log's start: figures of what the particles hold possible, of the first seed");
  visit("people_figures", o.people_figures,
        "of moments with people, of the first seed: scan, difference, tracking, weights; see "
        "'mapbed render --help'");
  visit("series_step", o.series_step, Unit::second, between(0.01, 1e6),
        "between the points of series over the log's time");
  visit_fields(o.evaluation, visit);
  visit("tracking", o.tracking, "how tracks are compared with the people who were there");
}

// The options, and the method that they name.
struct Setup {
  SlamOptions options;
  ChosenMethod method;
};

Setup setup_of(Settings settings) {
  const Settings of_filter = taken_people_filter(settings);
  const MethodSettings divided = divided_by_method(settings);
  Setup setup;
  apply(divided.own, options_of(setup.options), "slam");
  check_people_figures(setup.options.people_figures);
  setup.method = with_people_filter(chosen_method(setup.options.estimator, divided), of_filter);
  return setup;
}

std::string complete_yaml(Setup& setup) {
  return to_yaml(options_of(setup.options)) + method_yaml(setup.method);
}

ResultFile picture_file(const RunInput& input, SlamEvaluator& evaluator) {
  std::vector<DrawnPath> paths;
  if (!input.truth.empty()) paths.push_back({"true path", input.truth});
  paths.push_back({"estimated path", evaluator.world_from_robot()});
  const DrawnPoints dynamic =
      dynamic_points(input.log, evaluator.world_from_robot(), labels_in(evaluator.estimate()));
  return {"maps/map.png",
          png_of(picture_of(evaluator.map(), paths, {.longest_side = 1000}, dynamic))};
}

// As `mapbed map` writes it, in the frame of the path beside it.
void add_map_server_files(const RunInput& input, const MapOptions& options, const Trajectory& path,
                          std::vector<ResultFile>& files) {
  const OccupancyMap walls = wall_map(input.log, path, options);
  if (known_box(walls).empty()) return;
  MapText text = map_text(walls, "map.pgm");
  files.push_back({"maps/map.pgm", std::move(text.pgm)});
  files.push_back({"maps/map.yaml", std::move(text.yaml)});
}

// Of methods that have them, in the frame of the path beside it.
void add_graph_files(const RunInput& input, const MapOptions& options,
                     const SlamEvaluator& evaluator, std::vector<ResultFile>& files) {
  const Estimate& estimate = evaluator.estimate();
  if (estimate.graph) {
    PoseGraph<Pose2> graph = *estimate.graph;
    for (Pose2& node : graph.nodes) node = evaluator.world_from_map() * node;
    files.push_back({"graphs/graph.g2o", graph_text(graph)});
  }
  if (estimate.associations) {
    const Plot plot = association_plot(*estimate.associations, input.label);
    files.push_back({"graphs/associations.json", associations_json(*estimate.associations)});
    files.push_back({"figures/associations.svg", svg_of(plot)});
    files.push_back({"figures/associations.csv", csv_of(plot)});
    const Plot likelihood = likelihood_plot(*estimate.associations, input.label);
    files.push_back({"figures/likelihood.svg", svg_of(likelihood)});
    files.push_back({"figures/likelihood.csv", csv_of(likelihood)});
    for (auto& [name, png] : revision_maps(*estimate.associations, input.log, options)) {
      files.push_back({"maps/" + name, std::move(png)});
    }
  }
}

// The run to be watched, in the world's frame: what the laser said as it was recorded, labelled as
// the method's own input was.
ResultFile replay_file(const RunInput& input, const SensorLog& prepared,
                       const std::string& estimator, const SlamEvaluator& evaluator) {
  const Estimate& estimate = evaluator.estimate();
  Replay replay = input.recording == nullptr
                      ? Replay{.truth = input.truth, .scans = front_scans_of(input.log)}
                      : replay_of(input.recording->truth, input.log);
  replay.title = "The first seed, " + estimator;
  if (input.world != nullptr) replay.outlines = outlines_of(*input.world);
  replay.estimate = evaluator.world_from_robot();
  if (estimate.labels) replay.labels = labels_of_lasers(*estimate.labels, prepared);
  if (estimate.tracks) replay.tracks = transformed(*estimate.tracks, evaluator.world_from_map());
  return {"replays/run.json", replay_json(replay)};
}

// What comes of a method while it works.
struct Watched {
  MethodRun run;
  std::vector<ResultFile> figures;
  std::vector<Series> series;
};

// Where the run is shown, takes pictures of the particles on the way.
Watched watched_run(const Setup& setup, const RunInput& input, const SensorLog& as_recorded) {
  Watched watched;
  SlamSeries series(input, setup.options.series_step);
  std::vector<double> left = input.shown ? setup.options.snapshots : std::vector<double>{};
  std::sort(left.begin(), left.end(), std::greater<>());
  const double start = input.log.empty() ? 0.0 : time_of(input.log.front());
  const Pose2 world_from_map = input.truth.empty() ? Pose2{} : input.truth.front().pose;
  MethodWatch watch;
  watch.before = [&](const Measurement& measurement, const Estimator& estimator) {
    while (!left.empty() && time_of(measurement) - start > left.back()) {
      std::vector<ResultFile> files = path_figure(estimator.hypotheses(), input.truth,
                                                  world_from_map, left.back(), input.label);
      std::move(files.begin(), files.end(), std::back_inserter(watched.figures));
      left.pop_back();
    }
  };
  watch.after = [&](const Measurement& measurement, const Estimator& estimator) {
    if (std::holds_alternative<LaserScan>(measurement)) {
      series.look(time_of(measurement), estimator);
    }
    if (input.viewer != nullptr) input.viewer->after(measurement, estimator);
  };
  watch.all_added = [&](const Estimator& estimator) { watched.series = series.finish(estimator); };
  if (input.viewer != nullptr) input.viewer->begins(input, setup.method.name);
  watched.run = run_method(setup.method,
                           {.as_recorded = as_recorded,
                            .prepared = input.log,
                            .rng = input.rng.stream("estimator"),
                            .seed = input.seed,
                            .goes_on = input.goes_on},
                           watch);
  if (input.viewer != nullptr) input.viewer->ends(watched.run.estimate);
  return watched;
}

void tell_cost(const ChosenMethod& method, const MethodCost& cost, RunOutcome& outcome) {
  outcome.method_seconds = cost.processor_seconds;
  outcome.method_wall_seconds = cost.wall_seconds;
  outcome.program_memory = cost.peak_memory;
  if (method.program() != nullptr) outcome.program_seconds = cost.processor_seconds;
}

// Of what moves, where any of it is wanted.
void add_moving_values(const SlamOptions& options, const RunInput& input, const Estimate& estimate,
                       SlamEvaluator& evaluator, RunOutcome& outcome) {
  const std::vector<Metric> metrics = moving_metrics();
  const bool is_wanted = std::any_of(metrics.begin(), metrics.end(), [&](const Metric& metric) {
    return input.wanted.contains(metric.name);
  });
  if (!is_wanted) return;
  MovingEvaluator moving(options.tracking, options.evaluation.map, input, estimate,
                         evaluator.world_from_robot(), evaluator.map());
  for (auto& value : moving.values()) outcome.values.push_back(std::move(value));
}

RunOutcome run(const Setup& setup, const RunInput& whole_input) {
  RunInput input = shortened(whole_input, setup.options.longest);
  const SensorLog as_recorded =
      setup.method.program() == nullptr ? SensorLog{} : input.log;  // ours do without
  input.log = prepared(std::move(input.log), setup.options.input).log;
  Watched watched = watched_run(setup, input, as_recorded);
  const Estimate& estimate = watched.run.estimate;
  RunOutcome outcome;
  tell_cost(setup.method, watched.run.cost, outcome);

  SlamEvaluator evaluator(setup.options.evaluation, input, estimate);
  outcome.values = evaluator.values();
  add_moving_values(setup.options, input, estimate, evaluator, outcome);
  outcome.failure = evaluator.failure();
  outcome.files = std::move(watched.figures);
  outcome.series = std::move(watched.series);
  for (Series& series : series_of_associations(estimate, input)) {
    outcome.series.push_back(std::move(series));
  }
  for (Series& series : series_of_iterations(estimate, input)) {
    outcome.series.push_back(std::move(series));
  }
  for (auto& [name, content] : watched.run.kept) {
    if (input.shown) outcome.files.push_back({"program/" + name, std::move(content)});
  }
  if (input.shown && !known_box(evaluator.map()).empty()) {
    outcome.files.push_back(picture_file(input, evaluator));
    for (ResultFile& figure : files_of_figures(setup.options.people_figures, input)) {
      outcome.files.push_back(std::move(figure));
    }
    const Trajectory& path = evaluator.world_from_robot();
    outcome.files.push_back({"trajectories/estimate.tum", tum_text(path)});
    add_graph_files(input, setup.options.evaluation.map, evaluator, outcome.files);
    if (input.alone) {
      add_map_server_files(input, setup.options.evaluation.map, path, outcome.files);
    }
    // What the laser said, as it came.
    const RunInput input_as_recorded = shortened(whole_input, setup.options.longest);
    outcome.files.push_back(
        replay_file(input_as_recorded, input.log, setup.method.name, evaluator));
  }
  return outcome;
}

std::vector<Metric> all_metrics() {
  std::vector<Metric> metrics = slam_metrics();
  for (Metric& metric : moving_metrics()) metrics.push_back(std::move(metric));
  return metrics;
}

}  // namespace

Experiment slam_experiment() {
  const auto configure = [](const Settings& settings) {
    Setup setup = setup_of(settings);
    const std::string yaml = complete_yaml(setup);
    InputFiles files = setup.method.files;
    return Configured<RunOutcome(const RunInput&)>{
        yaml, [setup = std::move(setup)](const RunInput& input) { return run(setup, input); },
        std::move(files)};
  };
  return {.name = "slam",
          .about = "a method finds the trajectory in a log",
          .needs = Experiment::Needs::log,
          .metrics = all_metrics(),
          .configure = configure,
          .series = slam_series()};
}

}  // namespace mapbed
