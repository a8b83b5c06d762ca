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
std::string paragraph(const std::string& text, double size, FontWeight weight, double& y) {
  constexpr double kWidth = kPlotWidth - 2 * kEdge;
  const char* more = weight == FontWeight::bold ? "font-weight=\"bold\"" : "fill=\"#444\"";
  std::string result;
  for (const std::string& words : wrapped(text, size, kWidth, weight)) {
    y += size * kLine;
    const double fitting = fitting_size(words, size, kWidth, weight);
    result += svg_text(kEdge, y - 0.3 * size, words, {fitting, "start", more});
  }
  return result;
}

std::string legend_at(const std::vector<LegendEntry>& legend, double& y) {
  constexpr double kSymbol = 28.0, kGap = 6.0, kBetween = 16.0, kRow = 19.0;
  std::string result;
  double x = kEdge;
  y += 4.0;
  for (const LegendEntry& entry : legend) {
    const double size = fitting_size(entry.name, kSmall, kPlotWidth - 2 * kEdge - kSymbol - kGap);
    const double width = kSymbol + kGap + svg_text_width(entry.name, size) + kBetween;
    if (x > kEdge && x + width > kPlotWidth - kEdge + kBetween) {
      x = kEdge;
      y += kRow;
    }
    result += fmt::format("<g transform=\"translate({} {})\">{}</g>\n", coordinate(x),
                          coordinate(y + 3.0), entry.symbol);
    result += svg_text(x + kSymbol + kGap, y + 13.0, entry.name, {size});
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
  return widest(ticks) > width / static_cast<double>(axis.categories.size());
}

constexpr double kTurn = 35.0;                        // [deg]
constexpr double kTurnCos = 0.819, kTurnSin = 0.574;  // of it
constexpr double kTurnShift = 4.0;                    // [px] a turned name ends right of its tick
constexpr double kLeftmost = 2.0;                     // [px] where the longest of them may begin

// How wide a turned name at a tick at `x` may be.
double room_of_turned(double x) {
  return (x + kTurnShift - kLeftmost) / kTurnCos;
}

// Where the area must begin at least, for the turned names to lie in the picture; not beyond the
// middle of it. `right` is where it ends.
double left_for_turned(const std::vector<Tick>& ticks, const Scale& scale, double right) {
  double left = 0.0;
  for (const Tick& tick : ticks) {
    const double at = scale.fraction(tick.value);
    const double x = svg_text_width(tick.text, kSmall) * kTurnCos + kLeftmost - kTurnShift;
    left = std::max(left, (x - at * right) / std::max(1.0 - at, 0.01));
  }
  return std::min(left, 0.5 * right);
}

// [px] of the right half of a name that stands at the area's right end.
double beyond_right(const std::vector<Tick>& ticks, const Scale& scale) {
  for (auto tick = ticks.rbegin(); tick != ticks.rend(); ++tick) {
    if (tick->text.empty()) continue;
    return scale.fraction(tick->value) > 0.9 ? svg_text_width(tick->text, kSmall) / 2 : 0.0;
  }
  return 0.0;
}

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
                                           coordinate(x + kTurnShift), coordinate(base - 2.0));
      const double size = fitting_size(tick.text, kSmall, room_of_turned(x));
      result += svg_text(x + kTurnShift, base - 2.0, tick.text, {size, "end", turn});
    } else {
      result += svg_text(x, base, tick.text, {kSmall, "middle"});
    }
  }
  y = area.bottom() + 5.0 + 1.2 * kSmall;
  if (is_turned) y += widest(ticks) * kTurnSin;
  if (title_of(axis).empty()) return result;
  y += kTextSize * kLine;
  const double middle = area.left + area.width / 2;
  const double room = 2 * (std::min(middle, kPlotWidth - middle) - kLeftmost);
  const double size = fitting_size(title_of(axis), kTextSize, room);
  return result + svg_text(middle, y, title_of(axis), {size, "middle"});
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
  const double size = fitting_size(title_of(axis), kTextSize, 1.1 * area.height);
  return result + svg_text(x, y, title_of(axis), {size, "middle", turn});
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
  std::string head = paragraph(text.title, 14.5, FontWeight::bold, below);
  head += paragraph(text.subtitle, kSmall, FontWeight::regular, below);
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
  area.left = kEdge + 1.5 * kTextSize + widest(y_ticks) + 8.0;
  const int x_count = x_scale.logarithmic ? 6 : 9;
  const std::vector<Tick> x_ticks = ticks_of(x, x_scale, x_count);
  const double right =
      kPlotWidth - std::max(kEdge + 4.0 + text.free_right, beyond_right(x_ticks, x_scale));
  if (turned(x, x_ticks, right - area.left)) {
    area.left = std::max(area.left, left_for_turned(x_ticks, x_scale, right));
  }
  area.width = right - area.left;
  if (text.equal_scales) {
    make_scales_equal(area);
    y_ticks = ticks_of(y, area.y, 6);
  }
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
