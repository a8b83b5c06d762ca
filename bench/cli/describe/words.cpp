#include "bench/cli/describe/words.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "algorithms/grid/map_builder.h"
#include "bench/cli/catalogue.h"
#include "bench/experiments/experiment.h"
#include "core/config/quantity.h"
#include "robots/robot.h"
#include "sim/drivers/drivers.h"
#include "worlds/file/world_file_form.h"
#include "worlds/geometry/material.h"

namespace mapbed {
namespace {

using Entries = std::vector<CatalogueEntry>;

Entries material_entries() {
  Entries entries;
  for (const Material& material : standard_materials()) {
    const std::string kind = material.transmittance > 0.0 ? "glass, lets laser beams through"
                             : material.conductor         ? "conducts, reflects radio waves"
                                                          : "opaque";
    entries.push_back(
        {material.name,
         fmt::format("{}; reflects {:g} % of a laser's light", kind, 100.0 * material.reflectivity),
         [material] {
           Material shown = material;
           return fmt::format("color: [{}]  # red, green, blue, each from 0 to 1\n",
                              fmt::join(material.color, ", ")) +
                  to_yaml(options_of(shown));
         }});
  }
  return entries;
}

std::string of_unit(Unit unit) {
  return unit == Unit::none ? "" : ", " + unit_name(unit);
}

// What experiments say of a metric or series of that name; mostly all of them the same.
struct Measured {
  std::string about;
  std::string text;  // a line for each experiment
};

Entries metric_entries() {
  std::map<std::string, Measured> all;
  const auto add = [&all](const std::string& name, const std::string& about,
                          const std::string& experiment) {
    Measured& measured = all[name];
    if (measured.about.empty()) measured.about = about;
    measured.text += "experiment " + experiment + ": " + about + "\n";
  };
  for (const Experiment& experiment : experiments()) {
    for (const Metric& metric : experiment.metrics) {
      add(metric.name, metric.about + of_unit(metric.unit), experiment.name);
    }
    for (const SeriesMetric& series : experiment.series) {
      add(series.name,
          "a series over " + series.x_name + ": " + series.about + of_unit(series.unit),
          experiment.name);
    }
  }
  Entries entries;
  for (const auto& [name, measured] : all) {
    entries.push_back({name, measured.about, [text = measured.text] { return text; }});
  }
  return entries;
}

// An entry of a scenario's list `key`, as an example of the word.
CatalogueEntry word_of(const char* key, const char* name, const char* about, const char* example) {
  return {name, about,
          [key, example] { return fmt::format("{}:  # of a scenario\n  - {}\n", key, example); }};
}

Entries plot_entries() {
  const auto kind = [](const char* name, const char* about, const char* example) {
    return word_of("plots", name, about, example);
  };
  return {
      kind("lines", "means of a metric over an axis, a line for each variant",
           "{x: robot.odometry.rotation_sigma, y: translation_error}"),
      kind("bars", "means of a metric, the variants side by side", "{y: failures}"),
      kind("points", "a mark for each run: a metric or an axis against a metric",
           "{kind: points, x: path_length, y: failures}"),
      kind("heat_map", "means of a metric as colours, over two axes of numbers",
           "{kind: heat_map, x: hits, y: misses, value: occupancy, variants: [counting]}"),
      kind("series", "a series over its iterations or time, a line for each variant",
           "{kind: series, y: residual, log_y: true}"),
      kind("matrix", "means of a metric as colours, over two axes of names",
           "{kind: matrix, y: fault, x: log, value: error_ratio, log_value: true, mark: told}"),
  };
}

std::string text_of_drive(DriveKind kind) {
  std::vector<std::string> robots;
  for (const std::string& name : robot_names()) {
    if (load_robot(name).drive.kind == kind) robots.push_back(name);
  }
  DriveModel drive{.kind = kind};
  return fmt::format("robots: {}\ndriver: {}  # where nobody names another\n",
                     robots.empty() ? "none" : fmt::format("{}", fmt::join(robots, ", ")),
                     usual_driver(kind)) +
         "drive:  # of a robot's file\n" + indented(to_yaml(options_of(drive)));
}

Entries drive_entries() {
  static const std::map<std::string, std::string> kAbouts{
      {"synchro", "all wheels steer together; turns without scrubbing"},
      {"differential", "two driven wheels and a caster"},
      {"skid_steer", "four fixed wheels; turns by scrubbing"},
      {"omni", "four wheels with rollers; drives in any direction as it turns"},
      {"ackermann", "a car: two steered wheels ahead of two fixed ones"}};
  Entries entries;
  for (std::size_t i = 0; i < drive_kind_names().size(); ++i) {
    const std::string& name = drive_kind_names()[i];
    entries.push_back(
        {name, kAbouts.at(name), [i] { return text_of_drive(static_cast<DriveKind>(i)); }});
  }
  return entries;
}

Entries sensor_kind_entries() {
  return {{"laser", "a range finder whose beams lie in a plane",
           [] {
             LaserModel laser;
             return "kind: laser  # of a sensor's file; 'mapbed list sensors' shows those there "
                    "are\n" +
                    to_yaml(options_of(laser));
           }},
          {"rfid", "an antenna of an RFID reader; a robot's antennas take turns", [] {
             RfidModel rfid;
             return "kind: rfid  # of a sensor's file; 'mapbed list sensors' shows those there "
                    "are\n" +
                    to_yaml(options_of(rfid));
           }}};
}

Entries map_model_entries() {
  static const std::map<std::string, std::string> kAbouts{
      {"counting", "a cell keeps the fraction of beams that end in it, of those that reach it"},
      {"odds", "a cell keeps the odds that it is occupied, updated by each beam"},
      {"end_points_counting", "as counting, of the beams' end points alone"},
      {"end_points_odds", "as odds, of the beams' end points alone"}};
  MapOptions options;
  const OptionList list = options_of(options);
  const auto model =
      std::find_if(list.begin(), list.end(), [](const Option& o) { return o.path == "model"; });
  Entries entries;
  for (const std::string& name : std::get<Choice>(model->value).names) {
    entries.push_back({name, kAbouts.at(name), [name] {
                         return "use: --set map.model=" + name +
                                "  # 'mapbed describe map' shows the options\n";
                       }});
  }
  return entries;
}

Entries claim_entries() {
  const auto word = [](const char* name, const char* about, const char* example) {
    return word_of("claims", name, about, example);
  };
  const char* const plain = "{metric: failures, of: matched, at_most: raw, at: every level}";
  const char* const number = "{metric: occupancy, of: counting, equals: 0.7, within: 1e-9}";
  const char* const series = "{series: residual, take: last, of: matched, at_most: 1 cm}";
  return {
      word("metric", "what is compared: one of the scenario's metrics", plain),
      word("of", "the variant that the claim is about; every one where left out", plain),
      word("at_most", "holds where it is no larger than a number or that of a variant", plain),
      word("at_least", "holds where it is no smaller", plain),
      word("below", "holds where it is smaller", plain),
      word("above", "holds where it is larger", plain),
      word("equals", "holds where it is the same but for `within`", number),
      word("within", "how far `equals` may be off", number),
      word("times", "what it is compared with is multiplied by this",
           "{metric: relative_translation, of: matched, at_most: raw, times: 0.1}"),
      word("against_metric", "of the other variant; the same metric where left out",
           "{metric: final_error, of: matched, at_most: raw, against_metric: path_error}"),
      word("statistic", "over the seeds: mean, median, min, max, total; the mean where left out",
           "{metric: failures, of: matched, at_most: 0, statistic: total}"),
      word("at", "`every level`, `upper half` of them, or values of axes",
           "{metric: failures, of: matched, at_most: raw, at: {people: 10}}"),
      word("test", "`sign`: besides, pairs of runs differ that way more often than chance (5 %)",
           "{metric: success_rate, of: blurred, above: sharp, at: upper half, test: sign}"),
      word("take", "of a series: its first or last value", series),
  };
}

Entries form_entries() {
  return {{"world_file", "what the file of a world may say", world_file_form}};
}

}  // namespace

std::vector<CatalogueShelf> word_shelves() {
  return {{"materials", "material", material_entries},
          {"metrics", "metric", metric_entries},
          {"plots", "kind of plots", plot_entries},
          {"drives", "drive", drive_entries},
          {"sensor_kinds", "kind of sensors", sensor_kind_entries},
          {"map_models", "model of maps", map_model_entries},
          {"claims", "word of claims", claim_entries},
          {"forms", "form of a file", form_entries}};
}

}  // namespace mapbed
