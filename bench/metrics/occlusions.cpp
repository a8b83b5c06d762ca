#include "bench/metrics/occlusions.h"

#include <limits>
#include <map>
#include <optional>

namespace mapbed {
namespace {

// What is known of one true object so far.
struct Seen {
  double last_time = 0.0;                // [s] it counted
  bool is_hidden = false;                // since then
  std::optional<int> track;              // its latest
  double track_time = 0.0;               // [s]
  std::optional<int> track_before = {};  // the occlusion that is over, while its end is looked at
  double back_since = 0.0;               // [s]
};

}  // namespace

double Occlusions::fraction_kept() const {
  return all == 0 ? std::numeric_limits<double>::quiet_NaN()
                  : static_cast<double>(kept) / static_cast<double>(all);
}

Occlusions occlusions_in(const TrackingFrames& frames, const OcclusionOptions& options) {
  Occlusions result;
  std::map<int, Seen> seen;
  for (const TrackingFrame& frame : frames) {
    std::map<int, int> track_of;
    for (const MatchedPair& pair : matched_pairs(frame, options.max_distance)) {
      track_of[frame.truth[pair.truth].id] = frame.tracks[pair.track].id;
    }
    for (const TrueObject& object : frame.truth) {
      const auto found = seen.find(object.id);
      if (!object.counts) {
        if (found != seen.end() && object.is_hidden) found->second.is_hidden = true;
        continue;
      }
      Seen& of = seen[object.id];
      const double hidden_for = frame.time - of.last_time;
      if (of.is_hidden && hidden_for <= options.longest && of.track &&
          of.last_time - of.track_time <= options.settling) {
        ++result.all;
        of.track_before = of.track;
        of.back_since = frame.time;
      }
      of.is_hidden = false;
      of.last_time = frame.time;
      const auto track = track_of.find(object.id);
      if (of.track_before && frame.time - of.back_since > options.settling) of.track_before.reset();
      if (track == track_of.end()) continue;
      of.track = track->second;
      of.track_time = frame.time;
      if (!of.track_before) continue;
      if (*of.track_before == track->second) ++result.kept;
      of.track_before.reset();
    }
  }
  return result;
}

}  // namespace mapbed
