#pragma once

#include <string>
#include <vector>

#include "core/config/settings.h"
#include "core/geometry/pose3.h"
#include "core/image/image.h"

namespace mapbed {

// What tags receive of an antenna, all over a world.
struct AntennaPicture {
  std::string world;                     // a builder's name or a world file
  Settings world_settings = {};          // its options
  std::string antenna;                   // "x, y, z, heading", as in "7 m, 6.6 m, 0.6 m, 45 deg"
  std::string sensor = "alien_alr9780";  // a name or file of kind rfid
  double tag_height = 1.3;               // [m]
  std::vector<double> center = {};       // [m] of what is shown; empty: the antenna
  double reach = 0.0;                    // [m] to each side; 0: all of the world
  int longest_side = 1000;               // [pixels]
};

// The power in colours, walls at the tags' height in white, a line where every second tag answers,
// the antenna with an arrow, a scale in dBm. Tags look at the antenna, hang free, and have no
// shadowing. Throws InputError.
RgbImage picture_of(const AntennaPicture& picture);

}  // namespace mapbed
