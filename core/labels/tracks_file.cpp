#include "core/labels/tracks_file.h"

#include <cmath>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "core/file/csv_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

const CsvRow kColumns{"track", "time", "x", "y", "vx", "vy", "sxx", "sxy", "syy", "occluded"};

TrackState state_of(const std::vector<double>& v) {
  TrackState state;
  state.time = v[1];
  state.position = {v[2], v[3]};
  state.velocity = {v[4], v[5]};
  state.covariance << v[6], v[7], v[7], v[8];
  state.occluded = v[9] != 0.0;
  return state;
}

}  // namespace

std::string tracks_csv(const Tracks& tracks) {
  std::string text = csv_line(kColumns);
  for (const ObjectTrack& track : tracks) {
    for (const TrackState& s : track.states) {
      fmt::format_to(std::back_inserter(text),
                     "{},{:.6f},{:.4f},{:.4f},{:.3f},{:.3f},{:.5f},{:.5f},{:.5f},{}\n", track.id,
                     s.time, s.position.x(), s.position.y(), s.velocity.x(), s.velocity.y(),
                     s.covariance(0, 0), s.covariance(0, 1), s.covariance(1, 1),
                     s.occluded ? 1 : 0);
    }
  }
  return text;
}

Tracks parse_tracks(const std::string& name, std::string_view text) {
  const std::vector<CsvRow> rows = parse_csv(name, text);
  if (rows.empty() || rows.front() != kColumns) {
    throw InputError({name, 1}, "is no table of tracks: its columns are not " +
                                    csv_line(kColumns).substr(0, csv_line(kColumns).size() - 1));
  }
  std::map<int, ObjectTrack> by_id;
  for (std::size_t row = 1; row < rows.size(); ++row) {
    const SourceLocation place{name, static_cast<int>(row + 1)};
    std::vector<double> values;
    for (const std::string& field : rows[row]) {
      values.push_back(parse_csv_number(field));
      if (!std::isfinite(values.back())) {
        throw InputError(place, in_quotes(field) + " is not a number");
      }
    }
    if (values[0] != std::floor(values[0]) || std::abs(values[0]) > 1e9) {
      throw InputError(place, in_quotes(rows[row][0]) + " is not the number of a track");
    }
    const int id = static_cast<int>(values[0]);
    ObjectTrack& track = by_id[id];
    track.id = id;
    if (!track.states.empty() && !(values[1] > track.states.back().time)) {
      throw InputError(place, fmt::format("track {} goes back in time", id));
    }
    track.states.push_back(state_of(values));
  }
  Tracks tracks;
  for (auto& [id, track] : by_id) tracks.push_back(std::move(track));
  return tracks;
}

}  // namespace mapbed
