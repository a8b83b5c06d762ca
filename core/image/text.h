#pragma once

#include <string_view>

#include <Eigen/Core>

#include "core/image/image.h"

namespace mapbed {

// Text on pictures, in one font of simple strokes: ASCII and ° ± × ² µ. Any other sign is drawn as
// a box. Best from 10 to 30 pixels.
struct TextStyle {
  double size = 13.0;  // [pixels] from line to line it takes 1.25 of this; capitals are 0.7 high
  Rgb color = kBlack;
  double halo = 0.0;  // [pixels] width of a white edge that sets the text off from a map
};

// `start` is the left end of the base line, in pixels from the top left corner of the picture; it
// is moved to the nearest pixel, which keeps stems sharp. What lies outside is cut off.
void draw_text(RgbImage& image, const Eigen::Vector2d& start, std::string_view text,
               const TextStyle& style = {});

double text_width(std::string_view text, double size);  // [pixels]

}  // namespace mapbed
