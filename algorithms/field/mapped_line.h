#pragma once

#include <cmath>

namespace mapbed {

// The projection on the line of a mapped point, (I + [x y; y -x]) / 2 with (x, y) = (cos 2a, sin
// 2a), by the mean of such directions; nothing where they do not agree on one.
struct MappedLine {
  static constexpr float kAlong = 0.1F;  // of a distance along it that counts, as in the field
  static constexpr float kMinAgreement = 0.5F;  // of the directions that make it, as in tangent_of

  float half;  // 1/2, or 0
  float x, y;  // times 1/2

  MappedLine(float doubled_x, float doubled_y) {
    const float squared = doubled_x * doubled_x + doubled_y * doubled_y;
    const bool is_line = !(squared < kMinAgreement * kMinAgreement);
    const float scale = 0.5F / std::sqrt(squared);
    half = is_line ? 0.5F : 0.0F;
    x = is_line ? scale * doubled_x : 0.0F;
    y = is_line ? scale * doubled_y : 0.0F;
  }

  // To the mapped surface [m^2], of a point that lies off the mapped one.
  float squared_distance(float off_x, float off_y) const {
    const float xx = off_x * off_x, yy = off_y * off_y;
    const float squared_along = half * (xx + yy) + x * (xx - yy) + 2.0F * y * off_x * off_y;
    return xx + yy - (1.0F - kAlong * kAlong) * squared_along;
  }
};

}  // namespace mapbed
