#include "bench/experiments/rfid_reads/rfid_reads.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "bench/experiments/data_file.h"
#include "bench/experiments/rfid_reads/held_out_places.h"
#include "bench/experiments/rfid_reads/strength_figures.h"
#include "bench/experiments/rfid_reads/strength_score.h"
#include "core/statistics/quantile.h"

namespace mapbed {
namespace {

struct RfidReadsExperiment {
  std::string file;
  int port = 1;
  HeldOutOptions held_out;
  StrengthMapOptions strengths;
  PlaceSearchOptions search;
  bool drawn = false;
};

template <class Visitor>
void visit_fields(RfidReadsExperiment& o, Visitor&& visit) {
  visit("file", o.file, "a table of reads at known places, as it is or below MAPBED_DATA");
  visit("port", o.port, between(1, 2), "of the reader's two, whose strengths count");
  visit("held_out", o.held_out, "places that are held out");
  visit("strengths", o.strengths, "what strengths in space are learned as");
  visit("search", o.search, "where tags are looked for");
  visit("drawn", o.drawn, "figures of a link budget");
}

using Values = std::vector<std::pair<std::string, double>>;

void add_errors(const std::vector<StrengthScore::Position>& positions, const std::string& what,
                Values& values) {
  std::vector<double> plane, space;
  for (const StrengthScore::Position& position : positions) {
    const Eigen::Vector3d off = position.found - position.truth;
    plane.push_back(off.head<2>().norm());
    space.push_back(off.norm());
  }
  values.emplace_back(what + "_plane_error", median_of(plane));
  values.emplace_back(what + "_plane_error_90", quantile_of(plane, 0.9));
  values.emplace_back(what + "_error", median_of(space));
  values.emplace_back(what + "_error_90", quantile_of(space, 0.9));
}

void add_fit(const StrengthModel& model, Values& values) {
  const auto antennas = static_cast<double>(model.antennas.size());
  double falloff = 0.0, width = 0.0, shift = 0.0;
  for (std::size_t i = 0; i < model.antennas.size(); ++i) {
    const SpatialAntenna& a = model.antennas[i];
    const std::string number = std::to_string(i + 1);
    if (a.back > 0.0 && i < 4) {
      values.emplace_back("azimuth_" + number, a.azimuth);
      values.emplace_back("elevation_" + number, a.elevation);
    }
    falloff += a.falloff / antennas;
    width += a.beam_width / antennas;
    shift += a.position.norm() / antennas;
  }
  values.emplace_back("falloff", falloff);
  values.emplace_back("antenna_shift", shift);
  if (model.antennas.front().back > 0.0) values.emplace_back("beam_width", width);
  if (model.threshold.sigma > 0.0) values.emplace_back("threshold", model.threshold.least);
  if (model.reflector.factor != 0.0) {
    values.emplace_back("floor_height", model.reflector.height);
    values.emplace_back("floor_factor", model.reflector.factor);
  }
}

// The errors of blocks, sorted: a distribution.
Series distribution_of(const std::vector<StrengthScore::Position>& positions,
                       const std::string& name) {
  std::vector<double> errors;
  for (const StrengthScore::Position& position : positions) {
    errors.push_back((position.found - position.truth).norm());
  }
  Series series{.name = name};
  for (int percent = 2; percent <= 98; percent += 2) {
    series.points.push_back({0.01 * percent, quantile_of(errors, 0.01 * percent)});
  }
  return series;
}

RunOutcome run(const RfidReadsExperiment& options, const PlacedReads& reads,
               const RunInput& input) {
  const std::vector<StrengthCell> cells = strength_cells(reads, options.port);
  const std::vector<int> folds =
      folds_of(reads.places, options.held_out, input.rng.stream("folds"));
  const StrengthScore score =
      held_out_score(cells, reads, folds, options.strengths, options.search);

  double squares = 0.0, count = 0.0;
  for (const StrengthScore::Prediction& prediction : score.predictions) {
    squares += prediction.cell.squares_about(prediction.strength);
    count += prediction.cell.reads;
  }
  const double beside = spread_beside_places(cells);
  RunOutcome outcome;
  outcome.values = {
      {"rms", std::sqrt(squares / count)},
      {"rms_of_means", std::sqrt(score.squares)},
      {"log_likelihood", score.log_likelihood},
      {"explained", 1.0 - score.squares / score.baseline_squares},
      {"explainable", 1.0 - beside * beside / score.baseline_squares},
      {"noise_floor", noise_of(reads, options.port)},
      {"reads", count},
  };
  add_errors(score.blocks, "block", outcome.values);
  add_errors(score.tags, "tag", outcome.values);
  outcome.series = {distribution_of(score.blocks, "block_errors"),
                    distribution_of(score.tags, "tag_errors")};
  if (options.strengths.predictor != StrengthPredictor::link_budget) return outcome;
  std::vector<StrengthReading> readings;
  for (const StrengthCell& cell : cells) readings.push_back(cell.reading);
  const StrengthModel model = fitted_strength(
      readings, reads.antennas, static_cast<int>(reads.tags.size()), options.strengths.fit);
  add_fit(model, outcome.values);
  if (options.drawn && input.shown) {
    outcome.files = strength_figures(score, model, cells, reads);
  }
  return outcome;
}

Configured<RunOutcome(const RunInput&)> configure(const Settings& settings,
                                                  const std::shared_ptr<ReadsFiles>& files) {
  RfidReadsExperiment options;
  apply(settings, options_of(options), "rfid_reads");
  Configured<RunOutcome(const RunInput&)> configured{.complete_yaml = to_yaml(options_of(options))};
  const std::string path = place_of_data(options.file);
  if (path.empty()) {
    configured.missing = "the reads " + in_quotes(options.file) + " are not here";
  } else {
    configured.files.push_back(input_file(path));
  }
  configured.make = [options = std::move(options), path, files](const RunInput& input) {
    return run(options, files->at(path), input);
  };
  return configured;
}

std::vector<Metric> metrics() {
  std::vector<Metric> all{
      {"rms", Unit::none, "of the RSSI of reads at places held out, less what was predicted [dB]"},
      {"rms_of_means", Unit::none, "the same of the means of a tag at a place by an antenna [dB]"},
      {"log_likelihood", Unit::none, "mean of such a read, as a density per dB"},
      {"explained", Unit::none,
       "share of what the mean of antenna and tag leaves between these means, held out"},
      {"explainable", Unit::none,
       "the same by a number for each antenna at each place and one for each tag, in sample: no "
       "function of the place alone comes above it"},
      {"noise_floor", Unit::none,
       "spread of RSSI at one place, of one antenna, carrier and tag [dB]"},
      {"reads", Unit::none, "that were predicted"}};
  for (const auto& [name, what] :
       {std::pair<std::string, std::string>{"block", "by all tags at a place together"},
        {"tag", "by one tag alone, from the middle of its block"}}) {
    all.push_back({name + "_plane_error", Unit::meter, "median in the plane, " + what});
    all.push_back({name + "_plane_error_90", Unit::meter, "90 % of them are within it"});
    all.push_back({name + "_error", Unit::meter, "median in space, " + what});
    all.push_back({name + "_error_90", Unit::meter, "90 % of them are within it"});
  }
  for (int i = 1; i <= 4; ++i) {
    const std::string number = std::to_string(i);
    all.push_back({"azimuth_" + number, Unit::radian, "of that antenna's boresight, all places"});
    all.push_back({"elevation_" + number, Unit::radian, "the same above the horizon"});
  }
  all.insert(all.end(),
             {{"falloff", Unit::none, "of RSSI for ten times the distance [dB], mean antenna"},
              {"beam_width", Unit::radian, "between points of -3 dB, mean antenna"},
              {"antenna_shift", Unit::meter, "of antennas from the origin, mean"},
              {"threshold", Unit::none, "below which little is read [dBm]"},
              {"floor_height", Unit::meter, "of the plane that reflects"},
              {"floor_factor", Unit::none, "of the field that it reflects"}});
  return all;
}

}  // namespace

Experiment rfid_reads_experiment() {
  const auto files = std::make_shared<ReadsFiles>();
  return {.name = "rfid_reads",
          .about = "strengths of real RFID reads, and where tags are by them",
          .needs = Experiment::Needs::nothing,
          .metrics = metrics(),
          .configure = [files](const Settings& settings) { return configure(settings, files); },
          .series = {{"block_errors", Unit::meter, "share", Unit::none,
                      "errors in space that this share of the blocks is within"},
                     {"tag_errors", Unit::meter, "share", Unit::none,
                      "errors in space that this share of the tags is within"}}};
}

}  // namespace mapbed
