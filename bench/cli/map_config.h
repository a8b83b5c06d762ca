#pragma once

#include <cstdint>
#include <string>

#include "algorithms/grid/map_builder.h"
#include "algorithms/input/input_stage.h"
#include "bench/methods/chosen_method.h"
#include "core/config/settings.h"
#include "core/log/log_options.h"

namespace mapbed {

enum class MapFileKind : int { walls, graded };

// Everything that decides what `mapbed map` makes of a log.
//
//   method: scan_matching
//   seed: 1
//   map_file: walls # what map.pgm holds
//   log:            # how the log is read
//     max_range: 50 m
//   input:          # what of it a method may believe
//     odometry.max_speed: 3 m/s
//   map:            # how the map is made of scans and poses
//     resolution: 5 cm
//   scan_matching:  # the method's own options, under its name
//     climb.first_step: 10 cm
struct MapConfig {
  std::string method = "scan_matching";
  std::uint64_t seed = 1;
  MapFileKind map_file = MapFileKind::walls;
  LogOptions log = {};
  InputOptions input = {};
  MapOptions map = {};
  ChosenMethod chosen = {};  // what `method` and its settings come to
};

template <class Visitor>
void visit_fields(MapConfig& o, Visitor&& visit) {
  visit("method", o.method,
        "who finds the trajectory; 'mapbed list methods', or the file of a program of your own");
  visit("seed", o.seed, "of all chance");
  visit("map_file", o.map_file, {"walls", "graded"},
        "what map.pgm says of a cell: occupied, free or unknown, with closed walls (mode trinary); "
        "or map.model's value in percent (mode raw)");
  visit("log", o.log, "how the log is read");
  visit("input", o.input, "how what its sensors tell is prepared for methods");
  visit("map", o.map, "how the map is made of scans and poses");
}

// `start` with the settings written over it, the later of two winning. Throws InputError on
// anything unknown, with the place.
MapConfig map_config_from(const Settings& settings, MapConfig start = {});

// Complete, with units and meanings; map_config_from(load_settings(…)) of it gives the same again.
std::string to_yaml(MapConfig config);

}  // namespace mapbed
