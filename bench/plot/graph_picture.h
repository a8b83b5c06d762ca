#pragma once

#include <string>
#include <vector>

#include "algorithms/pose_graph/graph_file.h"

namespace mapbed {

// A graph as it is drawn: one of space is seen aslant from above.
struct GraphPanel {
  std::string title;
  AnyPoseGraph graph;
  std::vector<double> weights = {};  // of its constraints; none: all 1
};

// Panels side by side, each at its own scale, with a bar that says which: odometry as one path,
// what closes loops thin behind it, what has a weight below a half dashed before it. As SVG.
std::string graph_svg(const std::string& title, const std::string& subtitle,
                      const std::vector<GraphPanel>& panels);

}  // namespace mapbed
