#include "bench/metrics/tracking_frame.h"

#include <limits>

#include "core/assignment.h"

namespace mapbed {

std::vector<MatchedPair> matched_pairs(const TrackingFrame& frame, double max_distance) {
  Eigen::MatrixXd distance(frame.truth.size(), frame.tracks.size());
  for (std::size_t i = 0; i < frame.truth.size(); ++i) {
    for (std::size_t j = 0; j < frame.tracks.size(); ++j) {
      const double d = (frame.truth[i].position - frame.tracks[j].position).norm();
      distance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          d <= max_distance ? d : std::numeric_limits<double>::infinity();
    }
  }
  const std::vector<int> track_of = cheapest_assignment(distance);
  std::vector<MatchedPair> pairs;
  for (std::size_t i = 0; i < track_of.size(); ++i) {
    if (track_of[i] >= 0) pairs.push_back({i, static_cast<std::size_t>(track_of[i])});
  }
  return pairs;
}

TrackingFrames counting_alone(const TrackingFrames& frames, double max_distance) {
  TrackingFrames result;
  for (const TrackingFrame& frame : frames) {
    std::vector<bool> is_left_out(frame.tracks.size(), false);
    for (const MatchedPair& pair : matched_pairs(frame, max_distance)) {
      if (!frame.truth[pair.truth].counts) is_left_out[pair.track] = true;
    }
    TrackingFrame& kept = result.emplace_back();
    kept.time = frame.time;
    for (const TrueObject& object : frame.truth) {
      if (object.counts) kept.truth.push_back(object);
    }
    for (std::size_t j = 0; j < frame.tracks.size(); ++j) {
      if (!is_left_out[j]) kept.tracks.push_back(frame.tracks[j]);
    }
  }
  return result;
}

}  // namespace mapbed
