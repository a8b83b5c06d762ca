#include "bench/experiments/rfid/tag_mapping.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "algorithms/grid/wall_map.h"
#include "algorithms/input/input_stage.h"
#include "algorithms/rfid/learned_rfid.h"
#include "algorithms/rfid/tag_answer.h"
#include "algorithms/rfid/tag_mapper.h"
#include "algorithms/rfid/tags_file.h"
#include "bench/experiments/rfid/posed_rounds.h"
#include "bench/experiments/rfid/tag_aperture.h"
#include "bench/experiments/rfid/tag_path.h"
#include "bench/figures/tag_figures.h"
#include "bench/methods/chosen_method.h"
#include "core/image/png.h"
#include "core/input_error.h"
#include "core/statistics/moments.h"
#include "core/statistics/quantile.h"
#include "worlds/world.h"

namespace mapbed {
namespace {

// Figure 7.7, and the first detection.
const std::vector<int> kMoments{1, 6, 17, 65, 110, 200};

struct TagMappingOptions {
  std::string estimator = "rbpf";
  std::string model = "pioneer_rfid_piecewise";
  double caution = 1.0;
  TagMapperOptions mapper;
  bool sight = true;
  bool aperture = false;
  TagApertureOptions phases;
};

template <class Visitor>
void visit_fields(TagMappingOptions& o, Visitor&& visit) {
  visit("estimator", o.estimator, "who finds the robot's path; 'mapbed list methods', or 'truth'");
  visit("model", o.model,
        "what was learned of the antennas: a file of algorithms/rfid/rfid_models");
  visit("caution", o.caution, kFraction,
        "of a piecewise model: fraction of rounds that count as saying nothing; 1: Figure 7.4");
  visit("mapper", o.mapper, "how each tag's belief is made");
  visit("sight", o.sight, "silence says nothing of what is behind the walls of the map");
  visit("aperture", o.aperture, "tags are put where the phases of their answers agree");
  visit("phases", o.phases, "how these are put together");
}

struct Setup {
  TagMappingOptions options;
  ChosenMethod method;  // none by the true path
  LearnedRfid model;
};

LearnedRfid with_caution(LearnedRfid model, double caution) {
  for (AntennaModel& antenna : model) {
    if (auto* piecewise = std::get_if<PiecewiseAntenna>(&antenna)) piecewise->caution = caution;
  }
  return model;
}

std::map<std::string, Eigen::Vector2d, std::less<>> places_of(const World& world) {
  std::map<std::string, Eigen::Vector2d, std::less<>> places;
  for (const RfidTag& tag : world.tags) places[tag.id] = tag.world_from_tag.position.head<2>();
  return places;
}

// What was believed of each tag on the way.
using Histories = std::map<std::string, std::vector<BeliefMoment>, std::less<>>;

Histories mapped_on_the_way(TagMapper& mapper, const std::vector<PosedRound>& rounds,
                            const GoesOn& goes_on) {
  Histories histories;
  for (const PosedRound& posed : rounds) {
    throw_unless(goes_on);
    mapper.add(*posed.round, posed.map_from_robot);
    for (const RfidRead& read : posed.round->reads) {
      const int detections = mapper.detections(read.tag);
      if (!std::binary_search(kMoments.begin(), kMoments.end(), detections)) continue;
      histories[read.tag].push_back(
          {detections, mapper.belief(read.tag), posed.map_from_robot.position()});
    }
  }
  return histories;
}

struct MappedTags {
  std::vector<double> errors;   // [m]
  std::vector<double> spreads;  // [m]
  int one_mode = 0;
  int within_two_sigma = 0;
  std::vector<MappedTag> tags;
};

MappedTags judged(const std::vector<TagBelief>& beliefs,
                  const std::map<std::string, Eigen::Vector2d, std::less<>>& places,
                  const std::map<std::string, Eigen::Vector2d>& focused) {
  MappedTags result;
  for (const TagBelief& belief : beliefs) {
    const auto truth = places.find(belief.tag);
    if (truth == places.end()) continue;
    const TagAnswer answer = answer_of(belief);
    const auto by_phase = focused.find(belief.tag);
    const Eigen::Vector2d mapped =
        by_phase == focused.end() ? answer.most_likely : by_phase->second;
    const double error = (mapped - truth->second).norm();
    result.errors.push_back(error);
    result.spreads.push_back(answer.spread);
    if (answer.modes == 1) ++result.one_mode;
    // Of a normal distribution in the plane, 2 sigma of either axis hold 86 %.
    if ((answer.mean - truth->second).norm() <= std::sqrt(2.0) * answer.spread) {
      ++result.within_two_sigma;
    }
    result.tags.push_back({truth->second, mapped});
  }
  return result;
}

Series error_by_detections(const Histories& histories,
                           const std::map<std::string, Eigen::Vector2d, std::less<>>& places) {
  Series series{"error_by_detections", {}};
  for (const int detections : kMoments) {
    std::vector<double> errors;
    for (const auto& [tag, moments] : histories) {
      const auto truth = places.find(tag);
      if (truth == places.end()) continue;
      for (const BeliefMoment& moment : moments) {
        if (moment.detections != detections) continue;
        errors.push_back((answer_of(moment.belief).most_likely - truth->second).norm());
      }
    }
    if (!errors.empty()) series.points.push_back({1.0 * detections, median_of(errors)});
  }
  return series;
}

// Of the tag that is shown: the first that was heard as often as Figure 7.7 needs.
std::string shown_tag(const Histories& histories) {
  for (const auto& [tag, moments] : histories) {
    if (moments.size() == kMoments.size()) return tag;
  }
  return histories.empty() ? "" : histories.begin()->first;
}

void add_figures(const RunInput& input, const OccupancyMap& walls, const Histories& histories,
                 const std::vector<PosedRound>& rounds, const MappedTags& mapped,
                 RunOutcome& outcome) {
  if (known_box(walls).empty() || mapped.tags.empty()) return;
  outcome.files.push_back(
      {"maps/tags.png", png_of(tag_map_figure(walls, mapped.tags)), "where tags were mapped"});
  const std::string tag = shown_tag(histories);
  const auto places = places_of(*input.world);
  const auto truth = places.find(tag);
  if (truth == places.end()) return;
  outcome.files.push_back({"maps/belief.png",
                           png_of(belief_figure(histories.at(tag), truth->second)),
                           "what was believed of a tag"});
  std::vector<Eigen::Vector2d> left, right;
  for (const PosedRound& posed : rounds) {
    const bool heard = std::any_of(posed.round->reads.begin(), posed.round->reads.end(),
                                   [&](const RfidRead& read) { return read.tag == tag; });
    if (!heard) continue;
    (posed.round->antenna == 0 ? left : right).push_back(posed.map_from_robot.position());
  }
  outcome.files.push_back({"maps/heard_from.png",
                           png_of(heard_from_figure(walls, left, right, truth->second)),
                           "where that tag was heard"});
}

RunOutcome run(const Setup& setup, const RunInput& input) {
  if (input.world->tags.empty()) {
    throw InputError({}, "the world has no RFID tags", "choose one with tags, as the office");
  }
  (void)antennas_in(input.log);
  const TagPath path = tag_path(setup.options.estimator, setup.method, input, input);
  const std::vector<PosedRound> rounds = posed_rounds(input.log, path.world_from_robot);
  const auto walls = std::make_shared<OccupancyMap>(
      wall_map(prepared(input.log, {}).log, path.world_from_robot, {.resolution = 0.1}));
  TagMapper mapper(setup.model, setup.options.mapper, input.rng.stream("tags"),
                   setup.options.sight ? walls : nullptr);
  const Histories histories = mapped_on_the_way(mapper, rounds, input.goes_on);
  const std::vector<TagBelief> beliefs = mapper.beliefs();
  std::map<std::string, Eigen::Vector2d> focused;
  if (setup.options.aperture) focused = by_phases(beliefs, rounds, setup.options.phases);

  const auto places = places_of(*input.world);
  const MappedTags mapped = judged(beliefs, places, focused);
  double detections = 0.0;
  for (const PosedRound& posed : rounds) {
    detections += static_cast<double>(posed.round->reads.size());
  }
  const auto count = static_cast<double>(mapped.errors.size());
  RunOutcome outcome;
  outcome.values = {{"detections", detections},
                    {"rounds", static_cast<double>(rounds.size())},
                    {"tags_mapped", count},
                    {"path_error", path.error}};
  if (!mapped.errors.empty()) {
    outcome.values.emplace_back("error_median", median_of(mapped.errors));
    outcome.values.emplace_back("error_90", quantile_of(mapped.errors, 0.9));
    outcome.values.emplace_back("error_mean", mean_of(mapped.errors));
    outcome.values.emplace_back("spread_median", median_of(mapped.spreads));
    outcome.values.emplace_back("one_mode", mapped.one_mode / count);
    outcome.values.emplace_back("within_two_sigma", mapped.within_two_sigma / count);
  }
  outcome.series.push_back(error_by_detections(histories, places));
  if (input.shown) {
    outcome.files.push_back({"learned/tags.csv", tags_text(beliefs)});
    add_figures(input, *walls, histories, rounds, mapped, outcome);
  }
  return outcome;
}

Configured<RunOutcome(const RunInput&)> configure(const Settings& settings) {
  const MethodSettings divided = divided_by_method(settings);
  Setup setup;
  apply(divided.own, options_of(setup.options), "tag_mapping");
  std::string yaml = to_yaml(options_of(setup.options));
  InputFiles files{learned_rfid_file(setup.options.model)};
  setup.model = with_caution(load_learned_rfid(setup.options.model), setup.options.caution);
  if (setup.options.estimator != kTruePath) {
    setup.method = chosen_method(setup.options.estimator, divided);
    yaml += method_yaml(setup.method);
    files.insert(files.end(), setup.method.files.begin(), setup.method.files.end());
  }
  return {yaml, [setup = std::move(setup)](const RunInput& input) { return run(setup, input); },
          std::move(files)};
}

}  // namespace

Experiment tag_mapping_experiment() {
  return {.name = "tag_mapping",
          .about = "the tags that antennas hear along a path are mapped, section 7.5.1",
          .needs = Experiment::Needs::world,
          .metrics = {{"detections", Unit::none, "answers of tags on the way"},
                      {"rounds", Unit::none, "inventory rounds of all antennas"},
                      {"tags_mapped", Unit::none, "tags that were heard and are truly there"},
                      {"path_error", Unit::meter, "RMS error of the path's positions, aligned"},
                      {"error_median", Unit::meter, "of the tags' most likely positions"},
                      {"error_90", Unit::meter, "below which nine in ten of them lie"},
                      {"error_mean", Unit::meter, "mean of them"},
                      {"spread_median", Unit::meter,
                       "median root mean squared distance of what "
                       "is believed from its mean"},
                      {"one_mode", Unit::none, "fraction of the tags believed in one place"},
                      {"within_two_sigma", Unit::none,
                       "fraction of the tags within 2 sigma of the belief's mean; 0.86 of a normal "
                       "distribution"}},
          .configure = configure,
          .series = {{"error_by_detections", Unit::meter, "detections", Unit::none,
                      "median error of the tags' most likely positions when so many of their "
                      "answers had come"}}};
}

}  // namespace mapbed
