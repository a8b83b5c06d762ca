#pragma once

#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace mapbed {

// One sign of the stroke font, y upwards; the base line is y = 0, small letters are 6 high,
// capitals and digits 9, and letters such as g reach down to -3.
struct Glyph {
  std::vector<std::vector<Eigen::Vector2d>> strokes;
  double advance = 0.0;  // from its left edge to that of the next sign
};

// Cuts the first sign off UTF-8 text, which is not empty.
Glyph next_glyph(std::string_view& text);

}  // namespace mapbed
