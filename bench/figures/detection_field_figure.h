#pragma once

#include <string>
#include <vector>

#include "algorithms/rfid/antenna_model.h"
#include "core/image/image.h"

namespace mapbed {

// What was counted of one antenna, and what was fitted to it.
struct DetectionField {
  HistogramAntenna counted;
  PiecewiseAntenna piecewise;
  SmoothAntenna smooth;
  std::string name;  // "left antenna"
};

// Figures 7.3 and 7.4: rates of detection by the tag's place in the antenna's frame, the antenna
// looking to the right, with arc and disc of the piecewise model and the smooth one's half.
RgbImage detection_field_figure(const std::vector<DetectionField>& fields);

}  // namespace mapbed
