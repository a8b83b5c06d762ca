#pragma once

#include <string>

#include "algorithms/grid/occupancy_map.h"

namespace mapbed {

// Maps in the format of map_server and Nav2: a picture (PGM) and a YAML file that says where it
// lies. In its mode `trinary` a cell is occupied, free or unknown; what lies between the thresholds
// is unknown.
struct MapFileThresholds {
  double occupied = 0.65;  // above: occupied
  double free = 0.196;     // below: free. The grey of unknown cells, 205, is just above: 50/255
};

// Writes `stem`.pgm and `stem`.yaml, each complete or not at all. Throws InputError where they
// cannot be written, nothing is known, or the map is too large for a picture.
void write_map(const std::string& stem, const OccupancyMap& map,
               const MapFileThresholds& thresholds = {});

// The map that a YAML file describes, with probability 0 where free and 1 where occupied. A map
// whose origin is a multiple of its resolution gets the very cells it was written from. Throws
// InputError where a file is missing or damaged, and for what we do not read: other modes, turned
// maps.
OccupancyMap read_map(const std::string& yaml_path);

}  // namespace mapbed
