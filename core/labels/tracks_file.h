#pragma once

#include <string>
#include <string_view>

#include "core/labels/tracks.h"

// Tracks as a table, a row for each track and scan, by track and time:
//
//   track,time,x,y,vx,vy,sxx,sxy,syy,occluded
//
// in seconds and metres in the frame of the map; sxx, sxy, syy [m^2] are the position's covariance;
// occluded is 1 where nothing of it was seen.

namespace mapbed {

std::string tracks_csv(const Tracks& tracks);

// Throws InputError, with the line, for anything else.
Tracks parse_tracks(const std::string& name, std::string_view text);

}  // namespace mapbed
