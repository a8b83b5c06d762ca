#pragma once

#include "bench/figures/people_moments.h"
#include "core/image/image.h"

namespace mapbed {

// Figures 3.4 and 3.5: how likely a beam that ends at a place met each of the nearest people, and
// any of them (3.9); and the weight of each beam by that, (3.10) and (3.11).
RgbImage weights_figure(const std::vector<PeopleMoment>& moments, int longest_side);

}  // namespace mapbed
