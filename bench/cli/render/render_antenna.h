#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/cli/command_line.h"
#include "core/config/settings.h"
#include "core/image/image.h"

namespace mapbed {

struct AntennaArguments {
  std::string antenna;              // "x, y, z, heading"; empty: none is asked for
  std::string sensor;               // empty: the usual one
  std::string world;                // a builder's name or a world file
  Settings world_settings;          // its options
  Settings camera;                  // of which center and reach count
  std::optional<int> longest_side;  // [pixels]
};

std::vector<CommandOption> antenna_options(AntennaArguments& arguments);  // that it has alone

RgbImage picture_of_antenna(const AntennaArguments& arguments);  // throws InputError

}  // namespace mapbed
