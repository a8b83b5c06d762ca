#pragma once

#include <string>

#include "bench/plot/plot.h"

namespace mapbed {

// How the i-th series of a plot looks; differs from its neighbours in colour and, without colours,
// in dash, marker or hatching.
struct SeriesStyle {
  std::string color;   // "#0072b2"
  std::string dash;    // of a line: "6 3"; empty: unbroken
  std::string marker;  // SVG path data about (0, 0)
  bool filled = true;  // the marker
  int hatching = 0;    // of a bar; 0: none
};

SeriesStyle series_style(int index);

std::string marker_at(const SeriesStyle& style, double x, double y);

// The pattern that fills a bar, for <defs>; `id` is its name in the file.
std::string hatching_of(const SeriesStyle& style, const std::string& id);

// In the box of a legend; `hatching` as named in <defs>.
std::string legend_symbol(const SeriesStyle& style, Mark mark, bool band,
                          const std::string& hatching);

}  // namespace mapbed
