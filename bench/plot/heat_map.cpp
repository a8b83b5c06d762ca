#include "bench/plot/heat_map.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "bench/plot/plot_frame.h"
#include "bench/plot/svg_text.h"
#include "core/check.h"
#include "core/file/csv_file.h"
#include "core/image/color_map.h"
#include "core/image/png.h"

namespace mapbed {
namespace {

constexpr double kBarWidth = 14.0;  // [px] of the colour scale
constexpr double kBarRoom = 100.0;  // [px] for it and its numbers
constexpr int kPixelsPerUnit = 2;   // of the picture of the cells, for print

void check(const HeatMap& map) {
  CHECK(map.xs.size() >= 2 && map.ys.size() >= 2);
  CHECK(std::is_sorted(map.xs.begin(), map.xs.end()));
  CHECK(std::is_sorted(map.ys.begin(), map.ys.end()));
  CHECK(map.values.size() == map.xs.size() * map.ys.size());
}

double value_at(const HeatMap& map, std::size_t x, std::size_t y) {
  return map.values[y * map.xs.size() + x];
}

// Axes end where the outer cells do: half a cell beyond the outer places.
Scale cell_scale(const Axis& axis, const std::vector<double>& places) {
  const auto forth = [&](double v) { return axis.logarithmic ? std::log(v) : v; };
  const auto back = [&](double v) { return axis.logarithmic ? std::exp(v) : v; };
  CHECK(!axis.logarithmic || places.front() > 0.0);
  const std::size_t n = places.size();
  const double before = 0.5 * (forth(places[1]) - forth(places[0]));
  const double after = 0.5 * (forth(places[n - 1]) - forth(places[n - 2]));
  return {axis.low.value_or(back(forth(places[0]) - before)),
          axis.high.value_or(back(forth(places[n - 1]) + after)), axis.logarithmic};
}

std::size_t nearest(const std::vector<double>& places, const Scale& scale, double fraction) {
  const double value = scale.value(fraction);
  const auto after = std::lower_bound(places.begin(), places.end(), value);
  if (after == places.begin()) return 0;
  const auto index = static_cast<std::size_t>(after - places.begin());
  if (after == places.end()) return index - 1;
  const double to_low = fraction - scale.fraction(places[index - 1]);
  return to_low < scale.fraction(*after) - fraction ? index - 1 : index;
}

// The colour scale is padded by scale_of(); here the ends are those of the values themselves.
Scale color_scale(const HeatMap& map) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double v : map.values) {
    if (!std::isfinite(v) || (map.value.logarithmic && v <= 0.0)) continue;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  if (low >= high) return scale_of(map.value, map.values);
  return {map.value.low.value_or(low), map.value.high.value_or(high), map.value.logarithmic};
}

Rgb hatched(int x, int y) {
  return (x + y) % 10 < 2 ? Rgb{150, 150, 150} : Rgb{240, 240, 240};
}

RgbImage picture_of(const HeatMap& map, const PlotArea& area, const Scale& colors) {
  RgbImage image(static_cast<int>(area.width) * kPixelsPerUnit,
                 static_cast<int>(area.height) * kPixelsPerUnit);
  std::vector<std::size_t> columns;
  for (int x = 0; x < image.width(); ++x) {
    columns.push_back(nearest(map.xs, area.x, (x + 0.5) / image.width()));
  }
  for (int y = 0; y < image.height(); ++y) {
    const std::size_t row = nearest(map.ys, area.y, 1.0 - (y + 0.5) / image.height());
    for (int x = 0; x < image.width(); ++x) {
      const double fraction =
          colors.fraction(value_at(map, columns[static_cast<std::size_t>(x)], row));
      image.at(x, y) =
          std::isnan(fraction) ? hatched(x, y) : color_of(ColorMap::blue_to_yellow, fraction);
    }
  }
  return image;
}

std::string svg_image(double x, double y, double width, double height, const RgbImage& image) {
  return fmt::format(
      "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
      "style=\"image-rendering:pixelated\" href=\"{}\"/>\n",
      coordinate(x), coordinate(y), coordinate(width), coordinate(height),
      png_address(png_of(image)));
}

std::string color_bar(const HeatMap& map, const PlotArea& area, const Scale& colors) {
  RgbImage image(1, 256);
  for (int i = 0; i < 256; ++i)
    image.at(0, i) = color_of(ColorMap::blue_to_yellow, 1.0 - i / 255.0);
  const double x = area.right() + 16.0;
  std::string svg = svg_image(x, area.top, kBarWidth, area.height, image);
  svg += fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#222\"/>\n",
      coordinate(x), coordinate(area.top), coordinate(kBarWidth), coordinate(area.height));
  double widest = 0.0;
  for (const Tick& tick : ticks_of(colors, 6)) {
    if (tick.text.empty()) continue;
    widest = std::max(widest, svg_text_width(tick.text, 12.0));
    const double y = area.top + area.height * (1.0 - colors.fraction(tick.value));
    svg += fmt::format("<path d=\"M{} {}h4\" stroke=\"#222\"/>\n", coordinate(x + kBarWidth),
                       coordinate(y));
    svg += svg_text(x + kBarWidth + 6.0, y + 4.0, tick.text, {12.0});
  }
  const double at = std::min(x + kBarWidth + 6.0 + widest + 18.0, kPlotWidth - 8.0);
  const double middle = area.top + area.height / 2;
  const double size = fitting_size(title_of(map.value), kTextSize, 1.1 * area.height);
  return svg + svg_text(at, middle, title_of(map.value),
                        {size, "middle",
                         fmt::format("transform=\"rotate(-90 {} {})\"", coordinate(at),
                                     coordinate(middle))});
}

struct Corner {
  double x, y, value;
};

// Where the line of `level` crosses the border of a triangle; empty or one stretch. Triangles leave
// no ambiguity, unlike the squares of marching squares.
std::string contour_in(const Corner (&corners)[3], double level) {
  std::string data;
  for (int i = 0; i < 3; ++i) {
    const Corner& a = corners[i];
    const Corner& b = corners[(i + 1) % 3];
    if ((a.value < level) == (b.value < level)) continue;
    const double fraction = (level - a.value) / (b.value - a.value);
    data +=
        fmt::format("{}{} {}", data.empty() ? 'M' : 'L', coordinate(std::lerp(a.x, b.x, fraction)),
                    coordinate(std::lerp(a.y, b.y, fraction)));
  }
  return data;
}

std::string contours(const HeatMap& map, const PlotArea& area, const Scale& colors) {
  std::string data;
  for (const Tick& tick : ticks_of(colors, 6)) {
    const double level = colors.fraction(tick.value);
    if (tick.text.empty() || level <= 0.0 || level >= 1.0) continue;
    for (std::size_t y = 0; y + 1 < map.ys.size(); ++y) {
      for (std::size_t x = 0; x + 1 < map.xs.size(); ++x) {
        const auto corner = [&](std::size_t dx, std::size_t dy) {
          return Corner{area.px(map.xs[x + dx]), area.py(map.ys[y + dy]),
                        colors.fraction(value_at(map, x + dx, y + dy))};
        };
        const Corner a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
        if (!std::isfinite(a.value + b.value + c.value + d.value)) continue;
        data += contour_in({a, b, c}, level) + contour_in({a, c, d}, level);
      }
    }
  }
  if (data.empty()) return "";
  return fmt::format(
      "<path d=\"{0}\" fill=\"none\" stroke=\"#fff\" stroke-opacity=\"0.6\" "
      "stroke-width=\"2.2\"/>\n<path d=\"{0}\" fill=\"none\" stroke=\"#111\" "
      "stroke-width=\"0.8\"/>\n",
      data);
}

}  // namespace

std::string svg_of(const HeatMap& map) {
  check(map);
  const Scale colors = color_scale(map);
  FrameText text{map.title, map.subtitle, {}, kBarRoom};
  const bool holes = std::any_of(map.values.begin(), map.values.end(),
                                 [&](double v) { return std::isnan(colors.fraction(v)); });
  if (holes) {
    RgbImage image(28, 12);
    for (int y = 0; y < 12; ++y) {
      for (int x = 0; x < 28; ++x) image.at(x, y) = hatched(x, y);
    }
    text.legend.push_back({"no value", svg_image(0, 0, 28, 12, image)});
  }
  const PlotFrame frame =
      frame_of(text, map.x, map.y, cell_scale(map.x, map.xs), cell_scale(map.y, map.ys));
  const PlotArea& area = frame.area;
  std::string content = frame.head;
  content += svg_image(area.left, area.top, area.width, area.height, picture_of(map, area, colors));
  if (map.contours) content += contours(map, area, colors);
  content += color_bar(map, area, colors) + frame.axes;
  return svg_file(frame.height, map.title, content);
}

std::string csv_of(const HeatMap& map) {
  check(map);
  std::string text = csv_line({title_of(map.x), title_of(map.y), title_of(map.value)});
  for (std::size_t y = 0; y < map.ys.size(); ++y) {
    for (std::size_t x = 0; x < map.xs.size(); ++x) {
      text +=
          csv_line({csv_number(map.xs[x]), csv_number(map.ys[y]), csv_number(value_at(map, x, y))});
    }
  }
  return text;
}

}  // namespace mapbed
