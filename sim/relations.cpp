#include "sim/relations.h"

#include <cmath>

#include <fmt/format.h>

namespace mapbed {
namespace {

constexpr double kCloseAgain = 2.0;  // [m] that count as being at the same place

void add_relation(std::string& text, const Stamped<Pose2>& a, const Stamped<Pose2>& b) {
  const Pose2 motion = motion_between(a.pose, b.pose);
  text += fmt::format("{:.6f} {:.6f} {:.6f} {:.6f} 0 0 0 {:.7f}\n", a.time, b.time, motion.x,
                      motion.y, motion.theta);
}

}  // namespace

std::string relations_text(const Trajectory& truth, const RelationsOptions& options) {
  std::string text;
  std::vector<Stamped<Pose2>> kept;  // every `shortest` metres
  std::vector<double> ways;          // [m] of path up to there
  double way = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (i > 0) way += distance(truth[i - 1].pose, truth[i].pose);
    if (!kept.empty() && way - ways.back() < options.shortest) continue;
    kept.push_back(truth[i]);
    ways.push_back(way);
    if (kept.size() < 2) continue;
    add_relation(text, kept[kept.size() - 2], kept.back());
    // The nearest earlier pose from before the loop, if the robot has come back to one.
    std::size_t nearest = kept.size();
    double least = kCloseAgain;
    for (std::size_t k = 0; k + 1 < kept.size() && way - ways[k] > options.longest; ++k) {
      const double d = distance(kept[k].pose, kept.back().pose);
      if (d >= least) continue;
      least = d;
      nearest = k;
    }
    if (nearest < kept.size()) add_relation(text, kept[nearest], kept.back());
  }
  return text;
}

}  // namespace mapbed
