#include "algorithms/rbpf/loop_closing.h"

namespace mapbed {

bool is_back(const std::vector<Pose2>& path, const LoopClosingOptions& options) {
  double between = 0.0;  // [m] of path from pose i to the last one
  for (std::size_t i = path.size(); i-- > 1;) {
    between += distance(path[i - 1], path[i]);
    const bool long_ago = between >= options.path_between;
    if (long_ago && distance(path[i - 1], path.back()) <= options.distance) return true;
  }
  return false;
}

bool LoopDetector::closes(const std::vector<Pose2>& path, double inlier_ratio) {
  if (!is_back(path, options_)) {
    knows_the_area_ = false;
    return false;
  }
  if (knows_the_area_ || inlier_ratio < options_.min_inlier_ratio) return false;
  knows_the_area_ = true;
  return true;
}

}  // namespace mapbed
