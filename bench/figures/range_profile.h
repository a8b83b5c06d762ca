#pragma once

#include <vector>

#include "algorithms/people/front_end/leg_features.h"
#include "core/image/image.h"

namespace mapbed {

// The ranges of a scan over the bearings of its beams, those of leg features marked, as the lower
// half of Figure 3.3.
RgbImage range_profile(const ScanView& view, const std::vector<LegFeature>& features, int width,
                       int height, const Rgb& mark);

}  // namespace mapbed
