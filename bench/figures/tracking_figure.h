#pragma once

#include "bench/figures/people_moments.h"
#include "core/image/image.h"

namespace mapbed {

// Figure 3.3: samples of the people who are followed, with their ways, at several scans: through
// the longest occlusion, or up to a time.
RgbImage tracking_figure(const std::vector<PeopleMoment>& moments, int longest_side);

}  // namespace mapbed
