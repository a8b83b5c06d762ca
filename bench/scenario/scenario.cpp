#include "bench/scenario/scenario.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include <fmt/format.h>

#include "bench/results/plot_spec.h"
#include "bench/scenario/config_reader.h"
#include "core/config/config_node.h"
#include "core/config/suggestion.h"
#include "core/data_path.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDeepestBase = 8;  // files that build on each other
constexpr Bounds kSeeds = between(1, 100'000);

// What --quick makes less of.
struct QuickRules {
  int seeds = 1;
  int levels = 2;  // of each axis, spread evenly from the first to the last
  std::map<std::string, int> levels_of_axes;  // the same of those by these paths
  Settings settings;
  std::optional<bool> judges;  // nothing: with as many seeds and no other settings
};

struct Reading {
  Scenario scenario;
  QuickRules quick;
};

const std::vector<std::string> kKeys{"about",   "thesis", "base", "experiment", "sweep",
                                     "compare", "seeds",  "seed", "metrics",    "plots",
                                     "claims",  "quick",  "set",  "files"};

void check_has_values(const std::string& path, const std::vector<std::string>& texts,
                      const ConfigNode& node) {
  if (!texts.empty()) return;
  throw InputError(node.place(), "the sweep of '" + path + "' has no values",
                   "give one or more, or leave the sweep out");
}

SweepAxis swept_axis(const std::string& path, const ConfigNode& node) {
  if (node.kind() == ConfigNode::Kind::map) {
    SweepAxis axis = named_axis_of(path, node);
    check_has_values(path, axis.texts, node);
    return axis;
  }
  std::vector<std::string> texts;
  for (const ConfigNode& item : node.items()) {
    const bool is_value = item.kind() == ConfigNode::Kind::value;
    const std::string text =
        is_value ? with_whole_path(item.text(), item.place()) : item.flow_text();
    item.use_all();
    if (std::find(texts.begin(), texts.end(), text) != texts.end()) {
      throw InputError(item.place(),
                       in_quotes(text) + " comes twice in the sweep of '" + path + "'",
                       "keep one of them");
    }
    texts.push_back(text);
  }
  check_has_values(path, texts, node);
  SweepAxis axis = axis_of(path, std::move(texts));
  axis.place = node.place();
  return axis;
}

std::vector<Variant> variants_of(const ConfigNode& node) {
  std::vector<Variant> variants;
  for (const std::string& name : node.keys()) {
    variants.push_back(with_own_seeds({name, settings_of(node.at(name))}));
  }
  if (variants.empty()) {
    throw InputError(node.place(), "nothing to compare", "give one or more variants");
  }
  return variants;
}

QuickRules quick_rules_of(const ConfigNode& node) {
  QuickRules rules;
  if (const ConfigNode* seeds = node.find("seeds")) {
    rules.seeds = seeds->whole_number(kSeeds);
  }
  if (const ConfigNode* levels = node.find("levels")) {
    const Bounds some = between(1, 1000);
    if (levels->kind() == ConfigNode::Kind::map) {
      for (const std::string& path : levels->keys()) {
        rules.levels_of_axes[path] = levels->at(path).whole_number(some);
      }
    } else {
      rules.levels = levels->whole_number(some);
    }
  }
  if (const ConfigNode* set = node.find("set")) rules.settings = settings_of(*set);
  if (const ConfigNode* judges = node.find("judges")) rules.judges = judges->flag();
  return rules;
}

void append(Settings& all, const Settings& more) {
  all.insert(all.end(), more.begin(), more.end());
}

// Keys that are no part of the form of a scenario are settings.
void read_settings(const ConfigNode& file, Scenario& scenario) {
  for (const std::string& key : file.keys()) {
    if (std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end()) continue;
    const ConfigNode& node = file.at(key);
    append(scenario.settings, settings_of(key, node));
  }
  if (const ConfigNode* set = file.find("set")) append(scenario.settings, settings_of(*set));
}

void read_form(const ConfigNode& file, Reading& into) {
  Scenario& scenario = into.scenario;
  const auto read = [&file](const char* key, std::string& text) {
    if (const ConfigNode* node = file.find(key)) text = node->text();
  };
  read("about", scenario.about);
  read("thesis", scenario.thesis);
  if (const ConfigNode* experiment = file.find("experiment")) {
    scenario.experiment = experiment->text();
    scenario.experiment_place = experiment->place();
  }
  if (const ConfigNode* sweep = file.find("sweep")) {
    scenario.axes.clear();
    for (const std::string& path : sweep->keys()) {
      scenario.axes.push_back(swept_axis(path, sweep->at(path)));
    }
  }
  if (const ConfigNode* compare = file.find("compare")) scenario.variants = variants_of(*compare);
  if (const ConfigNode* seeds = file.find("seeds")) {
    scenario.seeds = seeds->whole_number(kSeeds);
  }
  if (const ConfigNode* seed = file.find("seed")) scenario.seed = seed->unsigned_number();
  if (const ConfigNode* metrics = file.find("metrics")) {
    scenario.metrics = metrics->texts();
    scenario.metrics_place = metrics->place();
  }
  if (const ConfigNode* plots = file.find("plots")) {
    scenario.plots.clear();
    for (const ConfigNode& plot : plots->items()) scenario.plots.push_back(plot_of(plot));
  }
  if (const ConfigNode* claims = file.find("claims")) {
    scenario.claims.clear();
    for (const ConfigNode& claim : claims->items()) scenario.claims.push_back(claim_of(claim));
  }
  if (const ConfigNode* quick = file.find("quick")) into.quick = quick_rules_of(*quick);
}

// The file's base first, so that the file itself has the last word.
void read_scenario(const fs::path& path, std::size_t depth, Reading& into) {
  const ConfigNode file = load_config(path.string());
  if (is_config(file)) {
    into.scenario = scenario_in(file);
    return;
  }
  if (const ConfigNode* base = file.find("base")) {
    if (depth >= kDeepestBase) {
      throw InputError(base->place(), "these files build on each other without end",
                       "take one 'base' out");
    }
    read_scenario(path.parent_path() / base->text(), depth + 1, into);
  }
  read_form(file, into);
  read_settings(file, into.scenario);
  if (const ConfigNode* files = file.find("files")) files->use_all();  // of a simulated log
  file.check_all_used();
}

std::vector<std::string> evenly_chosen(const std::vector<std::string>& texts, int count) {
  const auto wanted = static_cast<std::size_t>(count);
  if (texts.size() <= wanted) return texts;
  if (wanted == 1) return {texts.front()};
  std::vector<std::string> result;
  for (std::size_t i = 0; i < wanted; ++i) {
    result.push_back(texts[(i * (texts.size() - 1) + (wanted - 1) / 2) / (wanted - 1)]);
  }
  return result;
}

void make_quick(Reading& reading) {
  Scenario& scenario = reading.scenario;
  const bool all_there = reading.quick.seeds >= scenario.seeds && reading.quick.settings.empty();
  scenario.quick = true;
  scenario.judges = reading.quick.judges.value_or(all_there);
  scenario.seeds = std::min(scenario.seeds, reading.quick.seeds);
  for (SweepAxis& axis : scenario.axes) {
    const auto own = reading.quick.levels_of_axes.find(axis.path);
    const bool has_own = own != reading.quick.levels_of_axes.end();
    const int levels = has_own ? own->second : reading.quick.levels;
    axis = with_values(axis, evenly_chosen(axis.texts, levels), axis.place);
  }
  append(scenario.settings, reading.quick.settings);
}

void apply_choice(const ScenarioChoice& choice, Scenario& scenario) {
  if (choice.seed) scenario.seed = *choice.seed;
  for (const Setting& setting : choice.settings) {
    const auto axis = std::find_if(scenario.axes.begin(), scenario.axes.end(),
                                   [&](const SweepAxis& a) { return a.path == setting.path; });
    if (axis != scenario.axes.end()) {
      const ConfigNode node = parse_config(setting.text, setting.place);
      const bool is_list = node.kind() == ConfigNode::Kind::list;
      const SweepAxis given =
          is_list ? swept_axis(setting.path, node) : axis_of(setting.path, {setting.text});
      *axis = with_values(*axis, given.texts, setting.place);
    } else if (setting.path == "seeds") {
      scenario.seeds = ConfigNode(setting.text, setting.place).whole_number(kSeeds);
    } else if (setting.path == "experiment") {
      scenario.experiment = setting.text;
      scenario.experiment_place = setting.place;
    } else if (std::find(kKeys.begin(), kKeys.end(), setting.path) != kKeys.end()) {
      throw InputError(setting.place, in_quotes(setting.path) + " is not for --set",
                       "change it in the scenario file");
    } else {
      scenario.overrides.push_back(setting);
    }
  }
}

// What has options of its own: where the sweep or the command line chooses another one, the options
// that hold in the one of the first level say nothing of it.
bool is_choice_of_part(const std::string& path) {
  static const std::vector<std::string> kParts{"world",  "robot", "path",      "driver",
                                               "people", "log",   "estimator", "sensor"};
  const std::string name = path.substr(path.rfind('.') + 1);
  return std::find(kParts.begin(), kParts.end(), name) != kParts.end();
}

bool chooses_parts(const SweepAxis& axis) {
  if (axis.sets.empty()) return is_choice_of_part(axis.path);
  return std::any_of(axis.sets.begin(), axis.sets.end(), [](const Settings& set) {
    return std::any_of(set.begin(), set.end(),
                       [](const Setting& setting) { return is_choice_of_part(setting.path); });
  });
}

bool chooses_parts(const Scenario& scenario) {
  return std::any_of(scenario.axes.begin(), scenario.axes.end(),
                     [](const SweepAxis& axis) { return chooses_parts(axis); }) ||
         std::any_of(scenario.overrides.begin(), scenario.overrides.end(),
                     [](const Setting& setting) { return is_choice_of_part(setting.path); });
}

}  // namespace

Scenario load_scenario(const std::string& name_or_path, const ScenarioChoice& choice) {
  const fs::path path = find_data_file("scenario", "scenarios", name_or_path);
  Reading reading;
  reading.scenario.id = path.stem().string();
  reading.scenario.path = path.string();
  read_scenario(path, 0, reading);
  if (choice.quick) make_quick(reading);
  apply_choice(choice, reading.scenario);
  if (reading.scenario.variants.empty()) reading.scenario.variants.push_back({"all", {}});
  return std::move(reading.scenario);
}

Variant with_own_seeds(Variant variant) {
  for (const Setting& setting : variant.settings) {
    if (setting.path != "seeds") continue;
    variant.seeds = ConfigNode(setting.text, setting.place).whole_number(kSeeds);
  }
  std::erase_if(variant.settings, [](const Setting& s) { return s.path == "seeds"; });
  return variant;
}

std::vector<std::string> scenario_names() {
  return data_names("scenarios");
}

Settings settings_of(const Scenario& scenario, const Level& level, const Variant& variant) {
  Settings settings = chooses_parts(scenario) ? Settings{} : variant.complete;
  append(settings, scenario.settings);
  append(settings, variant.settings);
  append(settings, scenario.overrides);
  for (std::size_t i = 0; i < scenario.axes.size(); ++i) {
    append(settings, settings_at(scenario.axes[i], level.choice[i]));
  }
  return settings;
}

}  // namespace mapbed
