#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/results/claim.h"
#include "bench/results/results.h"
#include "core/config/config_node.h"
#include "core/config/settings.h"

namespace mapbed {

// One file, one experiment.
//
//   about: Does leaving people out of the map keep it straight as odometry gets worse?
//   thesis: Figure 3.10
//   base: parts/museum_tour.yaml          # another file of this kind that this one builds on
//   experiment: slam                      # 'mapbed list experiments'; slam where left out
//   world: museum                         # with robot, path and people: a simulated log;
//   robot: b21r                           # 'log: NAME' instead: a recorded one
//   driver: scripted                      # 'mapbed list drivers'; the first one where left out
//   sweep:
//     robot.odometry.rotation_sigma: [0 deg, 1 deg, 2 deg]
//     place: {hall: {world: museum}, maze: {world: office, people: 3}}   # several options, by
//     names; by numbers, as in {1 cm: {…}, 2 cm: {…}}, they stand along a plot's x together
//   compare:
//     raw: {estimator: odometry, seeds: 1}   # fewer than the others, where chance has no part in
//     it matched: {estimator: scan_matching}
//   seeds: 50                             # 50 runs of each, with the seeds seed, seed + 1, …
//   metrics: [translation_error, failures]
//   plots:
//     - {file: error, x: robot.odometry.rotation_sigma, y: translation_error}
//   claims:
//     - {metric: failures, of: matched, at_most: raw, at: every level}
//   quick: {seeds: 2, levels: 2}          # what --quick makes less of; `set` for more, levels of
//                                         # each axis by {path: count}. With fewer seeds or a
//                                         # `set`, claims are judged if it says `judges`
//
// Every other key is an option of the simulation (world.…, robot.…, simulation.…, driver.…,
// recorder.…), of how a log is read (log.…), a fault that is put into it (faults.…, faults.h) or of
// the experiment, nested or as a dotted path. An
// experiment that needs a further log, say one called mapping, has what differs in that log under
// its name, `mapping: {path: tour, people: 0}`; all else is as in the scenario's own.
//
// Paths are relative to the file that names them, on the command line to the working folder; in
// memory and in what is written they are whole ones. The config.yaml of a result is a scenario, too
// (config_text.h).
struct Variant {
  std::string name;
  Settings settings = {};
  Settings complete = {};         // that hold instead of the defaults; of a config.yaml only
  std::optional<int> seeds = {};  // fewer than the scenario's, for what chance has no part in
};

// Takes its 'seeds' out of a variant's settings. Throws InputError.
Variant with_own_seeds(Variant variant);

struct Scenario {
  std::string id;    // the file's name without .yaml
  std::string path;  // of the file
  std::string about;
  std::string thesis;
  std::string experiment = "slam";
  SourceLocation experiment_place = {};
  Settings settings;   // of all runs
  Settings overrides;  // from the command line, over everything but the axes
  std::vector<SweepAxis> axes;
  std::vector<Variant> variants;  // at least one; one of the name "all" where none are compared
  int seeds = 1;
  std::uint64_t seed = 1;
  std::vector<std::string> metrics;
  SourceLocation metrics_place = {};
  std::vector<PlotSpec> plots;
  std::vector<Claim> claims;
  bool quick = false;
  bool judges = true;  // as Results::judges
};

struct ScenarioChoice {
  bool quick = false;
  std::optional<std::uint64_t> seed = {};
  Settings settings = {};  // --set; 'seeds' too, and an axis, which then has these values only
};

// By name in scenarios/ or by path. Throws InputError with place, reason and remedy. What can only
// be known with the experiment (options, metrics, claims) is checked by make_plan.
Scenario load_scenario(const std::string& name_or_path, const ScenarioChoice& choice = {});

std::vector<std::string> scenario_names();

// What differs from the defaults in the runs of a level and variant; the later of two wins.
Settings settings_of(const Scenario& scenario, const Level& level, const Variant& variant);

}  // namespace mapbed
