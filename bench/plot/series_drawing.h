#pragma once

#include <string>

#include "bench/plot/plot.h"
#include "bench/plot/plot_frame.h"
#include "bench/plot/series_style.h"

namespace mapbed {

// Bars of one place, and points over one name, stand side by side: this series has place `slot` of
// `slots`. No slots: in the middle.
struct SidePlace {
  int slot = 0;
  int slots = 0;
  double pitch = 0.0;  // [px] from one place to the next

  double shift() const;  // [px] to the right
};

bool has_interval(const PlotSeries& series);

// The marks of a series within the area; `hatching` is the name of the pattern that fills bars.
std::string drawing_of(const PlotSeries& series, const PlotArea& area, const SeriesStyle& style,
                       const SidePlace& place, const std::string& hatching);

}  // namespace mapbed
