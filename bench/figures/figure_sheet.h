#pragma once

#include <string>
#include <vector>

#include "bench/plot/map_legend.h"
#include "core/image/image.h"

namespace mapbed {

struct FigurePanel {
  RgbImage image;
  std::string caption;  // below it, after its letter
};

// Pictures of one scale as one figure, row by row: "a", "b", ... below each, and below all of them
// a scale bar and a legend.
RgbImage sheet_of(const std::vector<FigurePanel>& panels, int columns, double pixels_per_meter,
                  const std::vector<LegendItem>& legend);

}  // namespace mapbed
