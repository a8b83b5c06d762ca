#include "bench/plot/series_drawing.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "bench/plot/svg_text.h"

namespace mapbed {
namespace {

constexpr std::size_t kMaxMarkers = 40;  // on a line; with more of them, only every n-th is drawn

struct Point {
  double x, y;  // [px]; NaN: a gap
  bool drawn() const { return std::isfinite(x) && std::isfinite(y); }
};

std::vector<Point> points_of(const PlotArea& area, const std::vector<double>& x,
                             const std::vector<double>& y) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < x.size(); ++i) points.push_back({area.px(x[i]), area.py(y[i])});
  return points;
}

std::string path_data(const std::vector<Point>& points) {
  std::string data;
  bool pen_down = false;
  for (const Point& p : points) {
    if (p.drawn()) {
      data += fmt::format("{}{} {}", pen_down ? 'L' : 'M', coordinate(p.x), coordinate(p.y));
    }
    pen_down = p.drawn();
  }
  return data;
}

// One closed outline for each stretch without a gap.
std::string band(const PlotArea& area, const PlotSeries& series, const SeriesStyle& style) {
  const std::vector<Point> low = points_of(area, series.x, series.low);
  const std::vector<Point> high = points_of(area, series.x, series.high);
  std::string data;
  for (std::size_t begin = 0; begin < low.size();) {
    std::size_t end = begin;
    while (end < low.size() && low[end].drawn() && high[end].drawn()) ++end;
    if (end > begin + 1) {
      std::vector<Point> outline(high.begin() + static_cast<std::ptrdiff_t>(begin),
                                 high.begin() + static_cast<std::ptrdiff_t>(end));
      for (std::size_t i = end; i-- > begin;) outline.push_back(low[i]);
      data += path_data(outline) + "Z";
    }
    begin = end + 1;
  }
  return data.empty() ? ""
                      : fmt::format("<path d=\"{}\" fill=\"{}\" fill-opacity=\"0.18\"/>\n", data,
                                    style.color);
}

std::string error_bar(double x, double low, double high, const std::string& color) {
  if (!std::isfinite(x) || !std::isfinite(low) || !std::isfinite(high)) return "";
  return fmt::format(
      "<path d=\"M{0} {1}V{2}M{3} {1}h6M{3} {2}h6\" stroke=\"{4}\" stroke-width=\"1.3\" "
      "fill=\"none\"/>\n",
      coordinate(x), coordinate(low), coordinate(high), coordinate(x - 3.0), color);
}

std::string line_svg(const PlotArea& area, const PlotSeries& series, const SeriesStyle& style) {
  const std::vector<Point> points = points_of(area, series.x, series.y);
  std::string svg = has_interval(series) ? band(area, series, style) : "";
  svg += fmt::format(
      "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\" "
      "stroke-linejoin=\"round\"{}/>\n",
      path_data(points), style.color,
      style.dash.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", style.dash));
  const std::size_t every = (points.size() + kMaxMarkers - 1) / kMaxMarkers;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool alone =
        (i == 0 || !points[i - 1].drawn()) && (i + 1 == points.size() || !points[i + 1].drawn());
    if (points[i].drawn() && (i % every == 0 || alone)) {
      svg += marker_at(style, points[i].x, points[i].y);
    }
  }
  return svg;
}

std::string thin_path(const PlotArea& area, const PlotSeries& series, const SeriesStyle& style) {
  return fmt::format(
      "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.2\" "
      "stroke-linejoin=\"round\"/>\n",
      path_data(points_of(area, series.x, series.y)), style.color);
}

// All dots are one path of strokes without length, which round ends make visible.
std::string dots_svg(const PlotArea& area, const PlotSeries& series, const SeriesStyle& style) {
  std::string data;
  for (const Point& p : points_of(area, series.x, series.y)) {
    if (p.drawn()) data += fmt::format("M{} {}h0", coordinate(p.x), coordinate(p.y));
  }
  return fmt::format(
      "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2.2\" stroke-linecap=\"round\" "
      "stroke-opacity=\"0.55\"/>\n",
      data, style.color);
}

std::string points_svg(const PlotArea& area, const PlotSeries& series, const SeriesStyle& style,
                       double shift) {
  std::string svg;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const Point p{area.px(series.x[i]) + shift, area.py(series.y[i])};
    if (!p.drawn()) continue;
    if (has_interval(series)) {
      svg += error_bar(p.x, area.py(series.low[i]), area.py(series.high[i]), style.color);
    }
    svg += marker_at(style, p.x, p.y);
  }
  return svg;
}

std::string bars_svg(const PlotArea& area, const PlotSeries& series, const SeriesStyle& style,
                     const SidePlace& place, const std::string& hatching) {
  const double width = 0.8 * place.pitch / place.slots;
  const double shift = place.shift();
  const double base = area.y.logarithmic || area.y.low > 0.0 ? area.bottom()
                      : area.y.high < 0.0                    ? area.top
                                                             : area.py(0.0);
  std::string svg;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const Point p{area.px(series.x[i]) + shift, area.py(series.y[i])};
    if (!p.drawn()) continue;
    svg += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"url(#{})\" stroke=\"{}\"/>\n",
        coordinate(p.x - 0.46 * width), coordinate(std::min(p.y, base)), coordinate(0.92 * width),
        coordinate(std::abs(base - p.y)), hatching, style.color);
    if (has_interval(series)) {
      svg += error_bar(p.x, area.py(series.low[i]), area.py(series.high[i]), "#111");
    }
  }
  return svg;
}

}  // namespace

double SidePlace::shift() const {
  return slots == 0 ? 0.0 : (slot - 0.5 * (slots - 1)) * 0.8 * pitch / slots;
}

bool has_interval(const PlotSeries& series) {
  return !series.low.empty();
}

std::string drawing_of(const PlotSeries& series, const PlotArea& area, const SeriesStyle& style,
                       const SidePlace& place, const std::string& hatching) {
  switch (series.mark) {
    case Mark::line:
      return line_svg(area, series, style);
    case Mark::points:
      return points_svg(area, series, style, place.shift());
    case Mark::bars:
      return bars_svg(area, series, style, place, hatching);
    case Mark::path:
      return thin_path(area, series, style);
    case Mark::dots:
      return dots_svg(area, series, style);
  }
  return "";
}

}  // namespace mapbed
