#include "bench/cli/describe/what_moved_text.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/statistics/quantile.h"

namespace mapbed {
namespace {

constexpr double kSoon = 2.0;  // [s] between the end of a track and another that goes on with it
constexpr double kNear = 1.5;  // [m]

double seconds_of(const ObjectTrack& track) {
  return track.states.back().time - track.states.front().time;
}

double way_of(const ObjectTrack& track) {
  double way = 0.0;  // [m]
  for (std::size_t i = 1; i < track.states.size(); ++i) {
    way += (track.states[i].position - track.states[i - 1].position).norm();
  }
  return way;
}

// Another begins where it ends, at about that time.
bool is_taken_over(const ObjectTrack& track, const Tracks& tracks) {
  const TrackState& end = track.states.back();
  return std::any_of(tracks.begin(), tracks.end(), [&](const ObjectTrack& other) {
    const TrackState& begin = other.states.front();
    return other.id != track.id && begin.time > track.states.front().time &&
           std::abs(begin.time - end.time) <= kSoon &&
           (begin.position - end.position).norm() <= kNear;
  });
}

}  // namespace

std::string text_of_tracks(const Tracks& tracks) {
  std::vector<double> seconds;
  double way = 0.0;
  std::size_t scans = 0, unseen = 0;
  for (const ObjectTrack& track : tracks) {
    seconds.push_back(seconds_of(track));
    way += way_of(track);
    scans += track.states.size();
    unseen += static_cast<std::size_t>(std::count_if(
        track.states.begin(), track.states.end(), [](const TrackState& s) { return s.occluded; }));
  }
  if (tracks.empty()) return "tracks: 0\n";
  const auto taken_over =
      std::count_if(tracks.begin(), tracks.end(),
                    [&](const ObjectTrack& track) { return is_taken_over(track, tracks); });
  return fmt::format(
      "tracks: {}, in {} scans each in the mean\nlength: {:.1f} s in the median, {:.1f} s the "
      "longest; {:.1f} m of way in all\nnot seen: in {:.1f} % of these scans\nlost and found: {} "
      "end where another begins, within {:g} s and {:g} m\n",
      tracks.size(), scans / tracks.size(), median_of(seconds),
      *std::max_element(seconds.begin(), seconds.end()), way,
      100.0 * static_cast<double>(unseen) / static_cast<double>(scans), taken_over, kSoon, kNear);
}

std::string text_of_labels(const BeamLabels& labels) {
  std::size_t beams = 0, labelled = 0, dynamic = 0;
  for (const ScanLabels& scan : labels) {
    beams += scan.static_probability.size();
    for (const float p : scan.static_probability) {
      labelled += std::isnan(p) ? 0 : 1;
      dynamic += is_dynamic(p) ? 1 : 0;
    }
  }
  return fmt::format(
      "scans: {}\nbeams: {}, {} of them with a label\ndynamic: {}, {:.2f} %\n", labels.size(),
      beams, labelled, dynamic,
      labelled == 0 ? 0.0 : 100.0 * static_cast<double>(dynamic) / static_cast<double>(labelled));
}

}  // namespace mapbed
