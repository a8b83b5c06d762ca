#include "bench/experiments/slam.h"

#include <algorithm>

#include <fmt/format.h>

#include "algorithms/estimator.h"
#include "algorithms/grid/map_builder.h"
#include "algorithms/grid/map_image.h"
#include "bench/metrics/map_error.h"
#include "bench/metrics/trajectory_error.h"
#include "bench/report/replay.h"
#include "core/geometry/tum_file.h"
#include "core/image/png.h"

namespace mapbed {
namespace {

struct SlamOptions {
  std::string estimator = "scan_matching";
  double success_distance = 1.0;  // [m]
  double failure_distance = 2.0;  // [m]
  double path_length = 5.0;       // [m]
  MapOptions map;
};

template <class Visitor>
void visit_fields(SlamOptions& o, Visitor&& visit) {
  visit("estimator", o.estimator, "who finds the trajectory; 'mapbed list methods'");
  visit("success_distance", o.success_distance, Unit::meter, kPositive,
        "a run with a smaller largest_error is a success");
  visit("failure_distance", o.failure_distance, Unit::meter, kPositive,
        "a run with a larger largest_error is a failure");
  visit("path_length", o.path_length, Unit::meter, kPositive,
        "of true path, over which relative errors are taken");
  visit("map", o.map, "how the map is made of scans and poses");
}

// The options, and the settings of the method that they name.
struct Setup {
  SlamOptions options;
  Settings of_method;
};

// Settings of methods stand under the method's name; those of other methods are checked as well.
Setup setup_of(const Settings& settings) {
  Setup setup;
  Settings own;
  std::vector<std::pair<std::string, Settings>> by_method;
  for (const Method& method : methods()) by_method.emplace_back(method.name, Settings{});
  for (Setting setting : settings) {
    const auto method = std::find_if(by_method.begin(), by_method.end(), [&](const auto& m) {
      return setting.path.starts_with(m.first + ".");
    });
    if (method == by_method.end()) {
      own.push_back(setting);
    } else {
      setting.path.erase(0, method->first.size() + 1);
      method->second.push_back(setting);
    }
  }
  apply(own, options_of(setup.options), "slam");
  (void)method_by_name(setup.options.estimator);
  for (const auto& [name, of_method] : by_method) {
    (void)method_by_name(name).complete_yaml(of_method);
    if (name == setup.options.estimator) setup.of_method = of_method;
  }
  return setup;
}

std::string complete_yaml(const Settings& settings) {
  Setup setup = setup_of(settings);
  std::string yaml = to_yaml(options_of(setup.options)) + setup.options.estimator + ":\n";
  const std::string inner = method_by_name(setup.options.estimator).complete_yaml(setup.of_method);
  for (std::size_t start = 0; start < inner.size();) {
    const std::size_t end = inner.find('\n', start) + 1;
    yaml += "  " + inner.substr(start, end - start);
    start = end;
  }
  return yaml;
}

double largest(const std::vector<PosePair>& pairs) {
  double result = 0.0;
  const Pose2 world_from_map = pairs.front().truth * inverse(pairs.front().estimate);
  for (const PosePair& pair : pairs) {
    result = std::max(result, distance(pair.truth, world_from_map * pair.estimate));
  }
  return result;
}

Trajectory transformed(const Trajectory& map_from_robot, const Pose2& world_from_map) {
  Trajectory result = map_from_robot;
  for (StampedPose& stamped : result) stamped.pose = world_from_map * stamped.pose;
  return result;
}

void judge_trajectory(const SlamOptions& options, const Trajectory& truth,
                      const std::vector<PosePair>& pairs, const Trajectory& estimate,
                      const Pose2& world_from_map, RunOutcome& outcome) {
  const PoseErrors absolute = absolute_error(pairs, world_from_map);
  const PoseErrors over_path = error_over_path(truth, estimate, options.path_length);
  const double largest_error = largest(pairs);
  auto& values = outcome.values;
  values.emplace_back("translation_error", absolute.translation.rmse);
  values.emplace_back("rotation_error", absolute.rotation.rmse);
  values.emplace_back("largest_error", largest_error);
  values.emplace_back("relative_translation", over_path.translation.mean);
  values.emplace_back("relative_rotation", over_path.rotation.mean);
  values.emplace_back("success", largest_error < options.success_distance ? 1.0 : 0.0);
  values.emplace_back("failures", largest_error > options.failure_distance ? 1.0 : 0.0);
  if (largest_error > options.failure_distance) {
    outcome.failure = fmt::format("largest position error {:.2f} m", largest_error);
  }
}

void judge_map(const OccupancyMap& map, const RunInput& input, RunOutcome& outcome) {
  const MapErrors errors = compare_maps(map, input.true_map(map.resolution()));
  outcome.values.emplace_back("map_f1", errors.f1());
  outcome.values.emplace_back("map_precision", errors.precision());
  outcome.values.emplace_back("map_recall", errors.recall());
}

bool wants_map(const RunInput& input) {
  return input.wanted.contains("map_f1") || input.wanted.contains("map_precision") ||
         input.wanted.contains("map_recall");
}

// The run to be watched, in the world's frame.
ResultFile replay_file(const RunInput& input, const std::string& estimator,
                       const Trajectory& world_from_robot) {
  Replay replay = input.recording == nullptr
                      ? Replay{.truth = input.truth, .scans = front_scans_of(input.log)}
                      : replay_of(input.recording->truth, input.log);
  replay.title = "The first seed, " + estimator;
  if (input.world != nullptr) replay.outlines = outlines_of(*input.world);
  replay.estimate = world_from_robot;
  return {"replays/run.json", replay_json(replay)};
}

RunOutcome run(const Settings& settings, const RunInput& input) {
  const Setup setup = setup_of(settings);
  const auto estimator =
      method_by_name(setup.options.estimator).make(setup.of_method, input.rng.stream("estimator"));
  for (const Measurement& measurement : input.log) estimator->add(measurement);
  const Estimate estimate = estimator->estimate();

  RunOutcome outcome;
  const Trajectory& path = estimate.trajectory;
  outcome.values.emplace_back("untrusted_scans", estimate.untrusted_scans);
  outcome.values.emplace_back("path_length", path_length(path));
  Pose2 world_from_map;
  const std::vector<PosePair> pairs = associated(input.truth, path);
  if (!pairs.empty()) {
    world_from_map = alignment(pairs);
    judge_trajectory(setup.options, input.truth, pairs, path, world_from_map, outcome);
  }
  const bool judges_map = wants_map(input) && input.true_map;
  if (!judges_map && !input.shown) return outcome;
  const Trajectory world_from_robot = transformed(path, world_from_map);
  const OccupancyMap map = build_map(input.log, world_from_robot, setup.options.map);
  if (judges_map) judge_map(map, input, outcome);
  if (input.shown && !known_box(map).empty()) {
    outcome.files.push_back({"maps/map.png", png_of(to_image(map))});
    outcome.files.push_back({"trajectories/estimate.tum", tum_text(world_from_robot)});
    outcome.files.push_back(replay_file(input, setup.options.estimator, world_from_robot));
  }
  return outcome;
}

}  // namespace

Experiment slam_experiment() {
  return {"slam",
          "a method finds the trajectory in a log",
          true,
          {{"translation_error", Unit::meter, "ATE: RMS distance, after the best alignment"},
           {"rotation_error", Unit::radian, "ATE: RMS turn, after the best alignment"},
           {"largest_error", Unit::meter, "largest distance, the first poses aligned"},
           {"relative_translation", Unit::meter, "mean error over path_length of true path"},
           {"relative_rotation", Unit::radian, "the same of the turn"},
           {"success", Unit::none, "1: largest_error is below success_distance", 0.0},
           {"failures", Unit::none, "1: largest_error is above failure_distance", 1.0},
           {"map_f1", Unit::none, "of occupied cells against the world's own map, see map_error.h"},
           {"map_precision", Unit::none, "share of the occupied cells that are right"},
           {"map_recall", Unit::none, "share of the true occupied cells that were found"},
           {"untrusted_scans", Unit::none, "scans whose match was not trusted"},
           {"path_length", Unit::meter, "of the estimated path"}},
          complete_yaml,
          run};
}

}  // namespace mapbed
