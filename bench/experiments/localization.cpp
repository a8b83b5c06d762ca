#include "bench/experiments/localization.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "algorithms/input/input_stage.h"
#include "bench/experiments/localization_blocks.h"
#include "bench/methods/method_run.h"
#include "bench/methods/people_filter.h"
#include "bench/plot/map_picture.h"
#include "bench/sources/shared_work.h"
#include "core/image/png.h"
#include "core/statistics/quantile.h"

namespace mapbed {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

enum class Begins : int { anywhere, told };

struct LocalizationOptions {
  std::string mapper = "rbpf";
  Begins begins = Begins::anywhere;
  double block = 30.0;    // [s]
  double near_map = 2.0;  // [m]
  double wrong = 1.0;     // [m]
  double longest = 0.0;   // [s]
  InputOptions input;
  MapOptions map;
};

template <class Visitor>
void visit_fields(LocalizationOptions& o, Visitor&& visit) {
  visit("mapper", o.mapper,
        "whose path is the true one where nobody knows that; 'mapbed list methods'");
  visit("begins", o.begins, {"anywhere", "told"},
        "in each block the robot begins anywhere on the map, or where it truly is");
  visit("block", o.block, Unit::second, between(1.0, 1e5),
        "length of a block; a map is made of every other one");
  visit("near_map", o.near_map, Unit::meter, kPositive,
        "from the path that the map was made on: a block that does not leave that counts as near");
  visit("wrong", o.wrong, Unit::meter, kPositive, "a pose is wrong that is farther off than this");
  visit("longest", o.longest, Unit::second, kNotNegative,
        "of the log, what comes later is left out; 0: all of it counts");
  visit("input", o.input, "how what sensors tell is prepared for methods");
  visit("map", o.map, "how the map is made of scans and poses");
}

struct Setup {
  LocalizationOptions options;
  ChosenMethod mapper;
  ChosenMethod localizer;
  std::string drive_yaml;  // what decides what is made of a log before anybody is localised
};

Setup setup_of(Settings settings) {
  const Settings of_filter = taken_people_filter(settings);
  const MethodSettings divided = divided_by_method(settings);
  Setup setup;
  LocalizationOptions& options = setup.options;
  apply(divided.own, options_of(options), "localization");
  setup.mapper = chosen_method(options.mapper, divided);
  if (setup.mapper.needs_map) {
    throw InputError("the mapper " + options.mapper + " makes no map, choose rbpf or graph");
  }
  setup.localizer = with_people_filter(chosen_method("localization", divided), of_filter);
  LocalizationOptions of_drive = options;
  of_drive.begins = Begins::anywhere;
  setup.drive_yaml = to_yaml(options_of(of_drive)) + method_yaml(setup.mapper);
  return setup;
}

std::string complete_yaml(Setup& setup) {
  return to_yaml(options_of(setup.options)) + method_yaml(setup.mapper) +
         method_yaml(setup.localizer);
}

// True, or by the mapper, at each scan of a level laser.
Trajectory path_in(const SensorLog& log, const Setup& setup, const RunInput& input) {
  if (input.truth.empty()) {
    return run_method(setup.mapper, {.as_recorded = input.log,
                                     .prepared = log,
                                     .rng = Rng(1).stream("mapper"),
                                     .seed = 1,
                                     .goes_on = input.goes_on})
        .estimate.trajectory;
  }
  Trajectory path;
  for (const Measurement& measurement : log) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr || !scan->robot_from_laser.is_level()) continue;
    path.push_back({scan->time, pose_at(input.truth, scan->time).value_or(Pose2{})});
  }
  return path;
}

DriveBlocks drive_of(const Setup& setup, const RunInput& input) {
  const LocalizationOptions& options = setup.options;
  const SensorLog log = prepared(input.log, options.input).log;
  return blocks_of(log, path_in(log, setup, input), options.block, options.near_map, options.map);
}

// What all blocks come to.
struct Sums {
  int blocks = 0, found = 0;
  int near_blocks = 0, near_lost = 0;
  int scans = 0, unknown = 0, wrongly_known = 0;
  std::vector<double> seconds, errors;

  void add(const BlockResult& result, bool is_near) {
    ++blocks;
    if (result.is_found) {
      ++found;
      seconds.push_back(result.seconds_to_it);
    }
    if (is_near) {
      ++near_blocks;
      if (!result.is_found) ++near_lost;
    }
    scans += result.scans;
    unknown += result.unknown;
    wrongly_known += result.wrongly_known;
    errors.insert(errors.end(), result.errors.begin(), result.errors.end());
  }
};

double fraction(int part, int whole) {
  return whole > 0 ? static_cast<double>(part) / whole : kNone;
}

RunOutcome run(const Setup& setup, const RunInput& whole_input) {
  const LocalizationOptions& options = setup.options;
  const RunInput input = shortened(whole_input, options.longest);
  const auto& drive =
      input.shared->once<DriveBlocks>(setup.drive_yaml, [&] { return drive_of(setup, input); });
  RunOutcome outcome;
  Sums sums;
  Estimate all;
  for (std::size_t i = 0; i < drive.blocks.size(); ++i) {
    const DriveBlocks::Block& block = drive.blocks[i];
    Given given{.map = drive.map};
    if (options.begins == Begins::told) given.start = block.truth.front().pose;
    const MethodRun found = run_method(setup.localizer, {.as_recorded = block.log,
                                                         .prepared = block.log,
                                                         .rng = input.rng.stream("localizer", i),
                                                         .seed = input.seed,
                                                         .goes_on = input.goes_on,
                                                         .given = given});
    outcome.method_seconds += found.cost.processor_seconds;
    outcome.method_wall_seconds += found.cost.wall_seconds;
    sums.add(judged(found.estimate, block.truth, options.wrong), block.is_near_map);
    const Trajectory& path = found.estimate.trajectory;
    all.trajectory.insert(all.trajectory.end(), path.begin(), path.end());
    all.lost.insert(all.lost.end(), found.estimate.lost.begin(), found.estimate.lost.end());
  }
  outcome.values = {
      {"blocks", sums.blocks},
      {"success", fraction(sums.found, sums.blocks)},
      {"seconds_to_success", median_of(sums.seconds)},
      {"error", median_of(sums.errors)},
      {"not_known", fraction(sums.unknown, sums.scans)},
      {"wrongly_known", fraction(sums.wrongly_known, sums.scans)},
      {"near_blocks", sums.near_blocks},
      {"near_lost", sums.near_lost},
  };
  if (input.shown && drive.map && !known_box(*drive.map).empty()) {
    outcome.files.push_back(
        {"maps/map.png", png_of(picture_of(*drive.map, {{"found", all.trajectory, all.lost}},
                                           {.longest_side = 1000}))});
  }
  return outcome;
}

std::vector<Metric> metrics() {
  return {
      {"blocks", Unit::none, "in which a robot was to be found"},
      {"success", Unit::none, "fraction of them: in the end it is known where it is, and right",
       0.0},
      {"seconds_to_success", Unit::second, "median time until it is, and stays so"},
      {"error", Unit::meter, "median, where the place counts as known"},
      {"not_known", Unit::none, "fraction of the scans whose place is said not to be known"},
      {"wrongly_known", Unit::none, "fraction of the scans whose place is known, and wrong", 1.0},
      {"near_blocks", Unit::none, "blocks near the path that the map was made on"},
      {"near_lost", Unit::none, "of these, without success"},
  };
}

}  // namespace

Experiment localization_experiment() {
  const auto configure = [](const Settings& settings) {
    Setup setup = setup_of(settings);
    const std::string yaml = complete_yaml(setup);
    InputFiles files = setup.mapper.files;
    files.insert(files.end(), setup.localizer.files.begin(), setup.localizer.files.end());
    return Configured<RunOutcome(const RunInput&)>{
        yaml, [setup = std::move(setup)](const RunInput& input) { return run(setup, input); },
        std::move(files)};
  };
  return {.name = "localization",
          .about = "a robot is localised in a map of half its drive, in the other half",
          .needs = Experiment::Needs::log,
          .metrics = metrics(),
          .configure = configure};
}

}  // namespace mapbed
