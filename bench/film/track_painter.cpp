#include "bench/film/track_painter.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bench/plot/track_style.h"
#include "bench/results/replay.h"
#include "core/image/drawing.h"

namespace mapbed {
namespace {

constexpr double kTrail = 5.0;      // [s]
constexpr double kStays = 0.5;      // [s] between two scans, or after the last one
constexpr double kDisc = 3.5;       // [pixels]
constexpr double kLeastRing = 5.0;  // [pixels]
constexpr int kDashes = 10;         // of a ring
constexpr double kNumber = 13.0;    // [pixels] its size

void add_ring(const Eigen::Vector2d& center, double radius, Coverage& coverage) {
  constexpr int kPoints = 4;  // of a dash, so that it is round
  for (int dash = 0; dash < kDashes; ++dash) {
    std::vector<Eigen::Vector2d> line;
    for (int i = 0; i < kPoints; ++i) {
      const double angle = 2.0 * M_PI * (dash + 0.5 * i / (kPoints - 1)) / kDashes;
      line.push_back(center + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    coverage.add_stroke(line, 1.6);
  }
}

void draw(const ObjectTrack& track, double time, const FilmView& view, Coverage& coverage,
          RgbImage& frame) {
  const auto is_before = [](const TrackState& state, double t) { return state.time <= t; };
  const auto later = std::lower_bound(track.states.begin(), track.states.end(), time, is_before);
  if (later == track.states.begin()) return;
  const TrackState& now = *(later - 1);
  if (time > now.time + kStays) return;
  std::vector<Eigen::Vector2d> trail;
  for (auto at = later; at != track.states.begin() && (at - 1)->time >= time - kTrail; --at) {
    trail.push_back(view.pixel_of((at - 1)->position));
  }
  coverage.add_stroke(trail, 1.8);
  const Eigen::Vector2d place = view.pixel_of(now.position);
  const Rgb color = track_color(track.id);
  if (now.occluded) {
    add_ring(place, std::max(kLeastRing, sigma_of(now) * view.pixels_per_meter()), coverage);
  } else {
    coverage.add_disc(place, kDisc);
  }
  coverage.blend_into(frame, color);
  if (place.allFinite()) {
    draw_text(frame, place + Eigen::Vector2d(6.0, -5.0), std::to_string(track.id),
              {.size = kNumber, .color = color, .halo = 2.0});
  }
}

}  // namespace

void draw_tracks(const Tracks& tracks, double time, const FilmView& view, Coverage& coverage,
                 RgbImage& frame) {
  for (const ObjectTrack& track : tracks) draw(track, time, view, coverage, frame);
}

}  // namespace mapbed
