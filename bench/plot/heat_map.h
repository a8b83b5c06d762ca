#pragma once

// A function of two variables as colours, from dark (low) to light (high); it survives a printer
// without colours. Where the function has no value, the picture is hatched.

#include <string>
#include <vector>

#include "bench/plot/axis.h"

namespace mapbed {

struct HeatMap {
  std::string title;
  std::string subtitle;
  Axis x;
  Axis y;
  Axis value;
  std::vector<double> xs;      // the places of the columns, rising; two or more
  std::vector<double> ys;      // of the rows, rising; two or more
  std::vector<double> values;  // row by row, that of ys[0] first; NaN: no value
  bool contours = true;        // lines of equal value at the ticks of the colours
};

std::string svg_of(const HeatMap& map);

// The numbers: x,y,value; no value is empty.
std::string csv_of(const HeatMap& map);

}  // namespace mapbed
