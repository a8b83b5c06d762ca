#pragma once

#include <optional>
#include <string>

#include "algorithms/grid/occupancy_map.h"

namespace mapbed {

// A map from its files: NAME.yaml as map servers read it, or a picture NAME.png whose place stands
// in the NAME.yaml beside it, or whose cells are `resolution` [m] wide and begin at the origin. A
// picture keeps how likely a cell is occupied; map servers know yes, no and unknown. Throws
// InputError.
OccupancyMap load_map(const std::string& path, std::optional<double> resolution = {});

}  // namespace mapbed
