#include "bench/plot/plot_frame.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "bench/plot/svg_text.h"

namespace mapbed {
namespace {

constexpr double kAreaHeight = 260.0;                        // [px] of the data
constexpr double kLeastHeight = 140.0, kMostHeight = 440.0;  // [px] the same with equal scales
constexpr double kEdge = 10.0;                               // [px] around everything
constexpr double kSmall = 12.0;                              // [px] size of ticks and legend
constexpr double kLine = 1.3;                                // distance of lines, in font sizes

std::string line(double x1, double y1, double x2, double y2, const std::string& color) {
  return fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"{}\"/>\n",
                     coordinate(x1), coordinate(y1), coordinate(x2), coordinate(y2), color);
}

// Writes lines of text from `y` down and moves `y` below them.
std::string paragraph(const std::string& text, double size, const std::string& more, double& y) {
  std::string result;
  for (const std::string& words : wrapped(text, size * 1.04, kPlotWidth - 2 * kEdge)) {
    y += size * kLine;
    result += svg_text(kEdge, y - 0.3 * size, words, {size, "start", more});
  }
  return result;
}

std::string legend_at(const std::vector<LegendEntry>& legend, double& y) {
  constexpr double kSymbol = 28.0, kGap = 6.0, kBetween = 16.0, kRow = 19.0;
  std::string result;
  double x = kEdge;
  y += 4.0;
  for (const LegendEntry& entry : legend) {
    const double width = kSymbol + kGap + 1.06 * svg_text_width(entry.name, kSmall) + kBetween;
    if (x > kEdge && x + width > kPlotWidth - kEdge + kBetween) {
      x = kEdge;
      y += kRow;
    }
    result += fmt::format("<g transform=\"translate({} {})\">{}</g>\n", coordinate(x),
                          coordinate(y + 3.0), entry.symbol);
    result += svg_text(x + kSymbol + kGap, y + 13.0, entry.name, {kSmall});
    x += width;
  }
  if (!legend.empty()) y += kRow;
  return result;
}

double widest(const std::vector<Tick>& ticks) {
  double width = 0.0;
  for (const Tick& tick : ticks) width = std::max(width, svg_text_width(tick.text, kSmall));
  return width;
}

// Names of categories that are too long to stand side by side are turned.
bool turned(const Axis& axis, const std::vector<Tick>& ticks, double width) {
  if (axis.categories.empty()) return false;
  return 1.06 * widest(ticks) > width / static_cast<double>(axis.categories.size());
}

constexpr double kTurn = 35.0;  // [deg]

std::string x_axis(const PlotArea& area, const Axis& axis, const std::vector<Tick>& ticks,
                   std::string& grid, double& y) {
  const bool is_turned = turned(axis, ticks, area.width);
  std::string result;
  for (const Tick& tick : ticks) {
    const double x = area.px(tick.value);
    const double length = tick.text.empty() ? 3.0 : 5.0;
    result += line(x, area.bottom(), x, area.bottom() + length, "#222");
    if (tick.text.empty()) continue;
    if (axis.categories.empty()) grid += line(x, area.top, x, area.bottom(), "#e4e4e4");
    const double base = area.bottom() + 5.0 + kSmall;
    if (is_turned) {
      const std::string turn = fmt::format("transform=\"rotate({} {} {})\"", -kTurn,
                                           coordinate(x + 4.0), coordinate(base - 2.0));
      result += svg_text(x + 4.0, base - 2.0, tick.text, {kSmall, "end", turn});
    } else {
      result += svg_text(x, base, tick.text, {kSmall, "middle"});
    }
  }
  y = area.bottom() + 5.0 + 1.2 * kSmall;
  if (is_turned) y += widest(ticks) * std::sin(kTurn * 3.14159265 / 180.0);
  y += kTextSize * kLine;
  result += svg_text(area.left + area.width / 2, y, title_of(axis), {kTextSize, "middle"});
  return result;
}

std::string y_axis(const PlotArea& area, const Axis& axis, const std::vector<Tick>& ticks,
                   std::string& grid) {
  std::string result;
  for (const Tick& tick : ticks) {
    const double y = area.py(tick.value);
    const double length = tick.text.empty() ? 3.0 : 5.0;
    result += line(area.left - length, y, area.left, y, "#222");
    if (tick.text.empty()) continue;
    grid += line(area.left, y, area.right(), y, "#e4e4e4");
    result += svg_text(area.left - 8.0, y + 0.35 * kSmall, tick.text, {kSmall, "end"});
  }
  const double x = kEdge + kTextSize * 0.8;
  const double y = area.top + area.height / 2;
  const std::string turn =
      fmt::format("transform=\"rotate(-90 {} {})\"", coordinate(x), coordinate(y));
  // A long title is set smaller rather than cut off.
  const double width = svg_text_width(title_of(axis), kTextSize);
  const double size = kTextSize * std::min(1.0, 1.1 * area.height / width);
  return result + svg_text(x, y, title_of(axis), {width > 0.0 ? size : kTextSize, "middle", turn});
}

void widen(Scale& scale, double span) {
  const double middle = (scale.low + scale.high) / 2;
  scale.low = middle - span / 2;
  scale.high = middle + span / 2;
}

// The height follows from the width; where that would be too low or too high, the axis that has
// room to spare goes further.
void make_scales_equal(PlotArea& area) {
  const double width = area.x.high - area.x.low, height = area.y.high - area.y.low;
  const double unit = std::max(width / area.width, height / kMostHeight);  // of a pixel
  area.height = std::max(kLeastHeight, height / unit);
  widen(area.x, unit * area.width);
  widen(area.y, unit * area.height);
}

}  // namespace

std::string svg_text(double x, double y, const std::string& text, const SvgTextStyle& style) {
  return fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\"{}{}>{}</text>\n",
                     coordinate(x), coordinate(y), coordinate(style.size), style.anchor,
                     style.more.empty() ? "" : " ", style.more, xml_escaped(text));
}

std::string head_of(const FrameText& text, double& below) {
  below = 4.0;
  std::string head = paragraph(text.title, 14.5, "font-weight=\"bold\"", below);
  head += paragraph(text.subtitle, kSmall, "fill=\"#444\"", below);
  head += legend_at(text.legend, below);
  return head;
}

PlotFrame frame_of(const FrameText& text, const Axis& x, const Axis& y, const Scale& x_scale,
                   const Scale& y_scale) {
  PlotFrame frame;
  double below = 0.0;
  frame.head = head_of(text, below);

  PlotArea& area = frame.area;
  area.x = x_scale;
  area.y = y_scale;
  area.top = below + 10.0;
  area.height = kAreaHeight;
  std::vector<Tick> y_ticks = ticks_of(y, y_scale, 6);
  area.left = kEdge + 1.5 * kTextSize + 1.06 * widest(y_ticks) + 8.0;
  area.width = kPlotWidth - area.left - kEdge - 4.0 - text.free_right;
  if (text.equal_scales) {
    make_scales_equal(area);
    y_ticks = ticks_of(y, area.y, 6);
  }
  const int x_count = x_scale.logarithmic ? 6 : 9;
  frame.axes = x_axis(area, x, ticks_of(x, area.x, x_count), frame.grid, frame.height);
  frame.axes += y_axis(area, y, y_ticks, frame.grid);
  frame.axes += fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#222\"/>\n",
      coordinate(area.left), coordinate(area.top), coordinate(area.width), coordinate(area.height));
  frame.height += kEdge;
  return frame;
}

std::string svg_file(double height, const std::string& title, const std::string& content) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\" role=\"img\" font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\" "
      "fill=\"#111\">\n<title>{2}</title>\n<rect width=\"{0}\" height=\"{1}\" "
      "fill=\"#fff\"/>\n{3}</svg>\n",
      coordinate(kPlotWidth), coordinate(std::ceil(height)), xml_escaped(title), content);
}

}  // namespace mapbed
