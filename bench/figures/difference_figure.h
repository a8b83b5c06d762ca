#pragma once

#include "bench/figures/people_moments.h"
#include "core/image/image.h"

namespace mapbed {

// Figure 3.2: grids of a scan and of one shortly before, matched, what differs between them, and
// which of the features moved by that.
RgbImage difference_figure(const std::vector<PeopleMoment>& moments, int longest_side);

}  // namespace mapbed
