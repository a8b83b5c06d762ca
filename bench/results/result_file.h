#pragma once

#include <string>

namespace mapbed {

// A file of a run's own, below the folder that says what it is: figures/ (SVG and its CSV), maps/,
// replays/, trajectories/, graphs/ (graph.g2o, associations.json), learned/, program/ (what a
// program of somebody else's was to keep), messages/ (what one that failed has said).
struct ResultFile {
  std::string path;  // "maps/map.png"; becomes that of its run: "maps/map_level_2_raw.png"
  std::string content;
  std::string title = {};  // what pages write below it, with the run: "map"; empty: nothing
};

}  // namespace mapbed
