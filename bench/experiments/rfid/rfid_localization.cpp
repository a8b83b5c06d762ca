#include "bench/experiments/rfid/rfid_localization.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "algorithms/grid/wall_map.h"
#include "algorithms/input/input_stage.h"
#include "algorithms/rfid/learned_rfid.h"
#include "algorithms/rfid/tag_answer.h"
#include "algorithms/rfid/tag_mapper.h"
#include "bench/experiments/localization_blocks.h"
#include "bench/experiments/rfid/posed_rounds.h"
#include "bench/experiments/rfid/tag_path.h"
#include "bench/methods/method_run.h"
#include "bench/methods/people_filter.h"
#include "bench/plot/map_picture.h"
#include "bench/sources/shared_work.h"
#include "core/image/png.h"
#include "core/input_error.h"
#include "core/statistics/quantile.h"
#include "worlds/world.h"

namespace mapbed {
namespace {

constexpr const char* kMapping = "mapping";  // the further log

struct RfidLocalizationOptions {
  std::string mapper = "rbpf";
  std::string model = "pioneer_rfid_smooth";
  TagMapperOptions tags{.non_detections = true, .news_distance = 0.25};
  bool in_corridor = true;
  double wrong = 1.0;        // [m]
  double longest = 120.0;    // [s]
  double series_step = 1.0;  // [s]
  MapOptions map;
};

template <class Visitor>
void visit_fields(RfidLocalizationOptions& o, Visitor&& visit) {
  visit("mapper", o.mapper, "who finds the path of the drive that maps, or 'truth'");
  visit("model", o.model, "by what tags are mapped: a file of algorithms/rfid/rfid_models");
  visit("tags", o.tags, "how they are mapped");
  visit("in_corridor", o.in_corridor, "particles begin near the path that was mapped from");
  visit("wrong", o.wrong, Unit::meter, kPositive, "a pose is wrong that is farther off than this");
  visit("longest", o.longest, Unit::second, kNotNegative,
        "of the drive in which the robot is found; 0: all of it");
  visit("series_step", o.series_step, Unit::second, between(0.01, 1e6),
        "between the points of the error over time");
  visit("map", o.map, "how the map is made");
}

struct Setup {
  RfidLocalizationOptions options;
  ChosenMethod mapper;  // none by the true path
  ChosenMethod localizer;
  LearnedRfid model;
  std::string mapping_yaml;  // what decides what comes of the drive that maps
};

// What the drive that maps gives.
struct MappedPlace {
  std::shared_ptr<const OccupancyMap> map;
  std::vector<TagBelief> tags;
  std::vector<Pose2> mapped_from;
};

MappedPlace mapped(const Setup& setup, const RunInput& input) {
  const LogInput& drive = input.further.at(kMapping);
  const TagPath path = tag_path(setup.options.mapper, setup.mapper, input, drive);
  MappedPlace place;
  const SensorLog log = prepared(drive.log, {}).log;
  place.map =
      std::make_shared<OccupancyMap>(wall_map(log, path.world_from_robot, setup.options.map));
  TagMapper mapper(setup.model, setup.options.tags, Rng(input.seed).stream("mapped tags"),
                   place.map);
  for (const PosedRound& posed : posed_rounds(drive.log, path.world_from_robot)) {
    mapper.add(*posed.round, posed.map_from_robot);
  }
  place.tags = mapper.beliefs();
  for (const Stamped<Pose2>& pose : path.world_from_robot) place.mapped_from.push_back(pose.pose);
  return place;
}

// Of the estimate, whether or not it says that it knows.
struct PlaceErrors {
  std::vector<SeriesPoint> over_time;  // [s] since the first, [m]
  std::vector<double> errors;          // [m]
  double right_from = NAN;             // [s] since then to the end; NaN: never
};

PlaceErrors errors_of(const Trajectory& path, const Trajectory& truth, double wrong, double step) {
  PlaceErrors result;
  double next = 0.0;
  for (const Stamped<Pose2>& stamped : path) {
    const std::optional<Pose2> true_pose = pose_at(truth, stamped.time);
    if (!true_pose) continue;
    const double error = distance(stamped.pose, *true_pose);
    const double time = stamped.time - path.front().time;
    result.errors.push_back(error);
    if (!(error <= wrong)) {
      result.right_from = NAN;
    } else if (std::isnan(result.right_from)) {
      result.right_from = time;
    }
    if (time < next) continue;
    result.over_time.push_back({next, error});
    next += step;
  }
  return result;
}

// Of the map that the robot is found by.
void add_tag_errors(const MappedPlace& place, const LogInput& drive, RunOutcome& outcome) {
  if (drive.world == nullptr) return;
  std::vector<double> errors;
  for (const TagBelief& belief : place.tags) {
    for (const RfidTag& tag : drive.world->tags) {
      if (tag.id != belief.tag) continue;
      const Eigen::Vector2d truth = tag.world_from_tag.position.head<2>();
      errors.push_back((answer_of(belief).most_likely - truth).norm());
    }
  }
  if (errors.empty()) return;
  outcome.values.emplace_back("tag_error_median", median_of(errors));
  outcome.values.emplace_back("tag_error_90", quantile_of(errors, 0.9));
}

RunOutcome run(const Setup& setup, const RunInput& whole_input) {
  const RfidLocalizationOptions& options = setup.options;
  const RunInput input = shortened(whole_input, options.longest);
  const LogInput& drive = input.further.at(kMapping);
  const MappedPlace& place = drive.shared->once<MappedPlace>("mapped place:\n" + setup.mapping_yaml,
                                                             [&] { return mapped(setup, input); });
  Given given{.map = place.map, .tags = place.tags};
  if (options.in_corridor) given.near = place.mapped_from;
  const SensorLog log = prepared(input.log, {}).log;
  const MethodRun found = run_method(setup.localizer, {.as_recorded = input.log,
                                                       .prepared = log,
                                                       .rng = input.rng.stream("localizer"),
                                                       .seed = input.seed,
                                                       .goes_on = input.goes_on,
                                                       .given = given});
  const BlockResult block = judged(found.estimate, input.truth, options.wrong);
  PlaceErrors errors =
      errors_of(found.estimate.trajectory, input.truth, options.wrong, options.series_step);
  RunOutcome outcome;
  outcome.method_seconds = found.cost.processor_seconds;
  outcome.method_wall_seconds = found.cost.wall_seconds;
  outcome.values = {{"success", std::isfinite(errors.right_from) ? 1.0 : 0.0},
                    {"tags", static_cast<double>(place.tags.size())}};
  if (!errors.errors.empty()) {
    outcome.values.emplace_back("error_median", median_of(errors.errors));
    outcome.values.emplace_back("error_end", errors.errors.back());
    // Of the last half: once it was found, where it was.
    const std::vector<double> later(
        errors.errors.begin() + static_cast<std::ptrdiff_t>(errors.errors.size() / 2),
        errors.errors.end());
    outcome.values.emplace_back("error_later", median_of(later));
  }
  if (std::isfinite(errors.right_from)) {
    outcome.values.emplace_back("seconds_to_success", errors.right_from);
  }
  if (block.scans > 0) {
    outcome.values.emplace_back("not_known", 1.0 * block.unknown / block.scans);
    outcome.values.emplace_back("wrongly_known", 1.0 * block.wrongly_known / block.scans);
  }
  add_tag_errors(place, drive, outcome);
  outcome.series.push_back({"error", std::move(errors.over_time)});
  if (input.shown && !known_box(*place.map).empty()) {
    outcome.files.push_back(
        {"maps/map.png",
         png_of(picture_of(*place.map,
                           {{"true path", input.truth},
                            {"found", found.estimate.trajectory, found.estimate.lost}},
                           {.longest_side = 1000}))});
  }
  return outcome;
}

Configured<RunOutcome(const RunInput&)> configure(const Settings& all_settings) {
  Settings settings = all_settings;
  const Settings of_filter = taken_people_filter(settings);
  const MethodSettings divided = divided_by_method(settings);
  Setup setup;
  RfidLocalizationOptions& options = setup.options;
  apply(divided.own, options_of(options), "rfid_localization");
  std::string yaml = to_yaml(options_of(options));
  setup.mapping_yaml = options.mapper + options.model + to_yaml(options_of(options.tags)) +
                       to_yaml(options_of(options.map));
  InputFiles files{learned_rfid_file(options.model)};
  setup.model = load_learned_rfid(options.model);
  if (options.mapper != kTruePath) {
    setup.mapper = chosen_method(options.mapper, divided);
    if (setup.mapper.needs_map) {
      throw InputError("the mapper " + options.mapper + " makes no map, choose rbpf or graph");
    }
    yaml += method_yaml(setup.mapper);
    setup.mapping_yaml += method_yaml(setup.mapper);
    files.insert(files.end(), setup.mapper.files.begin(), setup.mapper.files.end());
  }
  setup.localizer = with_people_filter(chosen_method("localization", divided), of_filter);
  yaml += method_yaml(setup.localizer);
  files.insert(files.end(), setup.localizer.files.begin(), setup.localizer.files.end());
  return {yaml, [setup = std::move(setup)](const RunInput& input) { return run(setup, input); },
          std::move(files)};
}

}  // namespace

Experiment rfid_localization_experiment() {
  return {.name = "rfid_localization",
          .about =
              "one drive maps a place and its tags, in another the robot is found there, "
              "section 7.5",
          .needs = Experiment::Needs::truth,
          .metrics = {{"success", Unit::none,
                       "its position is right from some time on to the end of the drive", 0.0},
                      {"seconds_to_success", Unit::second, "until then"},
                      {"error_median", Unit::meter, "of its position, over the whole drive"},
                      {"error_later", Unit::meter, "median over the second half of the drive"},
                      {"error_end", Unit::meter, "in the end"},
                      {"not_known", Unit::none,
                       "fraction of the scans whose place is said not to "
                       "be known"},
                      {"wrongly_known", Unit::none,
                       "fraction of the scans whose place is known, and wrong"},
                      {"tags", Unit::none, "that were mapped"},
                      {"tag_error_median", Unit::meter, "of their most likely positions"},
                      {"tag_error_90", Unit::meter, "below which nine in ten of them lie"}},
          .configure = configure,
          .series = {{"error", Unit::meter, "time", Unit::second, "error of the position"}},
          .further_logs = {kMapping}};
}

}  // namespace mapbed
