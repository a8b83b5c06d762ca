#pragma once

// What all plots share: titles, legend, axes with their ticks, and the area for the data.

#include <string>
#include <vector>

#include "bench/plot/axis.h"

namespace mapbed {

inline constexpr double kPlotWidth = 520.0;  // [px] of all plots; pages scale them
inline constexpr double kTextSize = 13.0;    // [px]

struct PlotArea {
  double left = 0.0;
  double top = 0.0;
  double width = 0.0;
  double height = 0.0;
  Scale x;
  Scale y;

  double px(double x_value) const { return left + width * x.fraction(x_value); }
  double py(double y_value) const { return top + height * (1.0 - y.fraction(y_value)); }
  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

struct LegendEntry {
  std::string name;
  std::string symbol;  // SVG in a box of 28 by 12 px, its middle at (14, 6)
};

struct FrameText {
  std::string title;
  std::string subtitle;
  std::vector<LegendEntry> legend;
  double free_right = 0.0;    // [px] kept free beside the area
  bool equal_scales = false;  // a unit is as long along y as along x; the area's height follows
};

struct PlotFrame {
  PlotArea area;
  double height = 0.0;  // [px] of the whole picture
  std::string head;     // titles and legend
  std::string grid;     // behind the data
  std::string axes;     // before the data
};

PlotFrame frame_of(const FrameText& text, const Axis& x, const Axis& y, const Scale& x_scale,
                   const Scale& y_scale);

// Titles and legend alone, from the top; `below` is where they end [px].
std::string head_of(const FrameText& text, double& below);

struct SvgTextStyle {
  double size = kTextSize;
  std::string anchor = "start";  // or middle, end
  std::string more = {};         // further attributes
};
std::string svg_text(double x, double y, const std::string& text, const SvgTextStyle& style = {});

// The whole file. `title` is what a screen reader says.
std::string svg_file(double height, const std::string& title, const std::string& content);

}  // namespace mapbed
