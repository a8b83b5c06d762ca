#pragma once

#include "bench/figures/people_moments.h"
#include "core/image/image.h"

namespace mapbed {

// Figure 3.1: a scan with what may be legs in it, how much each looks like one, and where the scan
// cannot see anybody; and its ranges, as they are looked through for local minima.
RgbImage scan_figure(const std::vector<PeopleMoment>& moments, int longest_side);

}  // namespace mapbed
