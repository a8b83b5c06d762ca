#include "bench/metrics/pairs.h"

namespace mapbed {

std::vector<Relation> pairs_of(const Trajectory& reference, const PairsOptions& options) {
  std::vector<double> driven;  // [m] up to each pose
  for (std::size_t i = 0; i < reference.size(); ++i) {
    driven.push_back(i == 0 ? 0.0
                            : driven.back() + distance(reference[i - 1].pose, reference[i].pose));
  }
  std::vector<Relation> pairs;
  for (std::size_t from = 0; from < reference.size(); ++from) {
    for (std::size_t to = from + 1; to < reference.size(); ++to) {
      if (driven[to] - driven[from] < options.after) continue;
      const Pose2& a = reference[from].pose;
      const Pose2& b = reference[to].pose;
      if (distance(a, b) > options.within) continue;
      pairs.push_back({reference[from].time, reference[to].time, motion_between(a, b)});
    }
  }
  return pairs;
}

}  // namespace mapbed
