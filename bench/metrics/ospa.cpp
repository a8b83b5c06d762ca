#include "bench/metrics/ospa.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/assignment.h"

namespace mapbed {

double ospa(const TrackingFrame& frame, double cut_off) {
  const std::size_t more = std::max(frame.truth.size(), frame.tracks.size());
  const std::size_t fewer = std::min(frame.truth.size(), frame.tracks.size());
  if (more == 0) return 0.0;
  Eigen::MatrixXd distance(frame.truth.size(), frame.tracks.size());
  for (std::size_t i = 0; i < frame.truth.size(); ++i) {
    for (std::size_t j = 0; j < frame.tracks.size(); ++j) {
      distance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          std::min(cut_off, (frame.truth[i].position - frame.tracks[j].position).norm());
    }
  }
  const double of_pairs = cost_of(cheapest_assignment(distance), distance);
  return (of_pairs + cut_off * static_cast<double>(more - fewer)) / static_cast<double>(more);
}

double mean_ospa(const TrackingFrames& frames, double cut_off) {
  if (frames.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0.0;
  for (const TrackingFrame& frame : frames) sum += ospa(frame, cut_off);
  return sum / static_cast<double>(frames.size());
}

}  // namespace mapbed
