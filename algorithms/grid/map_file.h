#pragma once

#include <optional>
#include <string>

#include "algorithms/grid/occupancy_map.h"
#include "core/image/map_server.h"

namespace mapbed {

// Maps from files and into files, in the format of core/image/map_server.h.

// Writes `stem`.pgm and `stem`.yaml, each complete or not at all: trinary, or raw, which keeps the
// probabilities. Throws InputError where they cannot be written, nothing is known, or the map is
// too large for a picture.
void write_map(const std::string& stem, const OccupancyMap& map,
               MapServerMode mode = MapServerMode::trinary);

// The same as texts, for files that are written together with others.
struct MapText {
  std::string pgm;
  std::string yaml;  // that says where the file `image` lies
};
MapText map_text(const OccupancyMap& map, const std::string& image,
                 MapServerMode mode = MapServerMode::trinary);

// A map from NAME.yaml, or from a picture as to_image() draws it, which keeps how likely a cell is
// occupied. The picture lies where the NAME.yaml beside it says, or its cells are `resolution` [m]
// wide and begin at the origin; a picture that this file itself names is read as the file says.
// Throws InputError.
OccupancyMap read_map(const std::string& path, std::optional<double> resolution = {});

// A map whose origin is a multiple of its resolution gets the very cells it was written from. Of a
// turned one, each cell takes the pixel that holds its centre.
OccupancyMap occupancy_map_of(const MapServerMap& map);

}  // namespace mapbed
