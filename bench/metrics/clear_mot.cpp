#include "bench/metrics/clear_mot.h"

#include <limits>
#include <map>

namespace mapbed {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

template <class Objects>
std::map<int, std::size_t> index_by_id(const Objects& objects) {
  std::map<int, std::size_t> index;
  for (std::size_t i = 0; i < objects.size(); ++i) index[objects[i].id] = i;
  return index;
}

// Pairs of the frame before that still hold, and then the others matched anew; by true id.
std::map<int, int> matches_in(const TrackingFrame& frame, const std::map<int, int>& before,
                              double max_distance) {
  const auto truths = index_by_id(frame.truth);
  const auto tracks = index_by_id(frame.tracks);
  std::map<int, int> matches;
  TrackingFrame left = frame;
  for (const auto& match : before) {
    const int truth_id = match.first, track_id = match.second;
    const auto truth = truths.find(truth_id);
    const auto track = tracks.find(track_id);
    if (truth == truths.end() || track == tracks.end()) continue;
    const Eigen::Vector2d apart =
        frame.truth[truth->second].position - frame.tracks[track->second].position;
    if (apart.norm() > max_distance) continue;
    matches[truth_id] = track_id;
    std::erase_if(left.truth, [&](const TrueObject& o) { return o.id == truth_id; });
    std::erase_if(left.tracks, [&](const TrackedObject& o) { return o.id == track_id; });
  }
  for (const MatchedPair& pair : matched_pairs(left, max_distance)) {
    matches[left.truth[pair.truth].id] = left.tracks[pair.track].id;
  }
  return matches;
}

}  // namespace

double ClearMot::accuracy() const {
  if (truths == 0) return kNone;
  return 1.0 -
         static_cast<double>(misses() + false_positives + switches) / static_cast<double>(truths);
}

double ClearMot::precision() const {
  return matches == 0 ? kNone : sum_of_distances / static_cast<double>(matches);
}

ClearMot clear_mot(const TrackingFrames& frames, double max_distance) {
  ClearMot result;
  std::map<int, int> in_frame_before;
  std::map<int, int> last_match;  // of each true object
  for (const TrackingFrame& frame : frames) {
    const auto truths = index_by_id(frame.truth);
    const auto tracks = index_by_id(frame.tracks);
    const std::map<int, int> matches = matches_in(frame, in_frame_before, max_distance);
    for (const auto& [truth_id, track_id] : matches) {
      const auto last = last_match.find(truth_id);
      if (last != last_match.end() && last->second != track_id) ++result.switches;
      last_match[truth_id] = track_id;
      result.sum_of_distances +=
          (frame.truth[truths.at(truth_id)].position - frame.tracks[tracks.at(track_id)].position)
              .norm();
    }
    result.truths += static_cast<long>(frame.truth.size());
    result.matches += static_cast<long>(matches.size());
    result.false_positives += static_cast<long>(frame.tracks.size() - matches.size());
    in_frame_before = matches;
  }
  return result;
}

}  // namespace mapbed
