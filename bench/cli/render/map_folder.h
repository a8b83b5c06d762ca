#pragma once

#include <string>

#include "bench/plot/map_picture.h"
#include "core/labels/tracks.h"

namespace mapbed {

// What a map shows besides its cells, in its frame.
struct WhatMoved {
  DrawnPoints dynamic;  // none without labels, or where the log is not to be found any more
  Tracks tracks;
};

// Of the folder that a map.yaml stands in, as `mapbed map --people-filter` has written it; nothing
// where it is another one. Throws InputError where its files are damaged.
WhatMoved what_moved(const std::string& map_yaml);

}  // namespace mapbed
