#pragma once

#include "bench/film/film_view.h"
#include "core/image/coverage.h"
#include "core/image/image.h"
#include "core/labels/tracks.h"

namespace mapbed {

// Those who are followed at a time [s], in the world's frame, each with its number and where it
// went in the last seconds: a disc where it is seen, a broken ring of its sigma where it is but
// held to be.
void draw_tracks(const Tracks& tracks, double time, const FilmView& view, Coverage& coverage,
                 RgbImage& frame);

}  // namespace mapbed
