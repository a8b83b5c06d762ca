#pragma once

#include <cstdint>
#include <string>

#include "core/config/settings.h"
#include "core/image/image.h"
#include "sim/render/render_world.h"

namespace mapbed {

// A picture of a world, empty or in the middle of a drive.
struct WorldPicture {
  std::string world;        // a builder's name or a world file
  Settings world_settings;  // its options
  std::string robot;        // that drives there, with people about; empty: the world alone
  std::string path;         // that it follows; empty: the world's first
  double after = 20.0;      // [s] of the drive
  std::uint64_t seed = 1;   // of people and doors
  RenderOptions camera;
};

// Whether the argument names a world and not a map: a name without ending, or a .yaml file that is
// no map server's (it has no key `image`).
bool is_world(const std::string& argument);

RgbImage picture_of(const WorldPicture& picture);  // throws InputError

}  // namespace mapbed
