#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/estimator.h"
#include "algorithms/grid/occupancy_map.h"
#include "algorithms/input/input_stage.h"
#include "bench/cli/map_config.h"
#include "bench/methods/program_run.h"
#include "bench/plot/map_picture.h"
#include "core/log/log_file.h"

namespace mapbed {

// What the machine needed; in no other result, for it differs from run to run.
struct MapCost {
  double estimating = 0.0;        // [s] all measurements through the method
  double mapping = 0.0;           // [s] the map of the poses
  double longest_scan = 0.0;      // [s] of a single scan
  double seconds_recorded = 0.0;  // [s] from the first to the last scan that was taken in
  int scans = 0;
  MethodCost of_program = {};  // of one that is the method
};

// A log turned into a map.
struct MapRun {
  MapConfig config;
  Estimate estimate;
  OccupancyMap map;      // of config.map's model
  OccupancyMap walls;    // what map.pgm shows: see wall_map.h, or the map itself
  int scans_in_log = 0;  // more than poses in the estimate: it was interrupted
  MapCost cost;
  std::string log_sha256 = {};  // of the log's file; empty where there is none to be read again
  bool was_interrupted = false;
  BeamLabels labels = {};    // of each laser's own scans; empty: the method gives none
  DrawnPoints dynamic = {};  // what they call dynamic, for the picture
  SensorLog cleaned = {};    // the log without what they call dynamic
  std::vector<std::pair<std::string, std::string>> kept = {};  // of a program's own files

  bool complete() const { return !was_interrupted; }
};

// Its remarks begin with those of the log. `may_go_on(done, total)` is asked after each
// measurement; false ends the run with what it has. A program that is the method gets the log
// `as_recorded`, and of methods that label beams it is what is cleaned; while it runs, the question
// comes again and again with nothing done, and false throws Interrupted. What goes wrong with it
// throws ProgramFailed.
MapRun make_map(const PreparedLog& prepared, const MapConfig& config,
                const std::function<bool(std::size_t done, std::size_t total)>& may_go_on,
                const SensorLog& as_recorded = {});

// The folder's files, all of them or none; an older map's are there until then:
//
//   trajectory.tum      a pose for each scan, by the log's own absolute stamps
//   map.pgm, map.yaml   for map servers: closed walls, or the model's values (map_file)
//   map.png             the model's values as greys, of the same cells
//   picture.png         for people: trajectory, scale bar, legend
//   config.yaml         complete; `mapbed map LOG --config` of it repeats the run
//   cost.csv            time and memory
//   labels.txt.gz       of methods that tell what moves: for each beam how likely it met the place
//                       (labels_file.h)
//   tracks.csv          of those that follow it (tracks_file.h)
//   cleaned.log.gz      the log, in CARMEN's form, without the beams that met what moves
//   graph.g2o           of methods that have a pose graph: its nodes and the constraints believed
//   associations.json   of those that search data associations: the tree (association_file.h), and
//   associations.svg    its picture
//   program/            what a program that is the method was to keep
//   summary.json        the rest in numbers; written last
//
// Throws InputError where one cannot be written. The folder is locked, and nothing is being
// published in it.
void write_map_run(const std::string& folder, const std::string& log_name, const RecordedLog& log,
                   const MapRun& run);

// Throws InputError where one of these would take the place of somebody else's file.
void refuse_foreign_map_files(const std::string& folder, const MapConfig& config);

// The `log_name` of the map that a folder holds; empty where it holds none.
std::string log_of_map(const std::string& folder);

}  // namespace mapbed
