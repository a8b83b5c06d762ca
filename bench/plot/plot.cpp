#include "bench/plot/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "bench/plot/plot_frame.h"
#include "bench/plot/series_drawing.h"
#include "bench/plot/svg_text.h"
#include "core/check.h"
#include "core/file/csv_file.h"

namespace mapbed {
namespace {

bool stands_aside(const Plot& plot, const PlotSeries& series) {
  return series.mark == Mark::bars || (series.mark == Mark::points && !plot.x.categories.empty());
}

// The least distance between two places; all of the area for a single place.
double place_pitch(const PlotArea& area, const Plot& plot) {
  std::vector<double> places;
  for (const PlotSeries& series : plot.series) {
    if (!stands_aside(plot, series)) continue;
    for (const double x : series.x) {
      if (std::isfinite(area.px(x))) places.push_back(area.px(x));
    }
  }
  std::sort(places.begin(), places.end());
  double pitch = area.width;
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i] - places[i - 1] > 0.5) pitch = std::min(pitch, places[i] - places[i - 1]);
  }
  return pitch;
}

void check(const Plot& plot) {
  for (const PlotSeries& series : plot.series) {
    const std::size_t size = series.x.size();
    CHECK(series.y.size() == size);
    CHECK(series.low.size() == series.high.size());
    CHECK(series.low.empty() || series.low.size() == size);
  }
}

Scale x_scale_of(const Plot& plot) {
  std::vector<double> values;
  bool bars = false;
  for (const PlotSeries& series : plot.series) {
    values.insert(values.end(), series.x.begin(), series.x.end());
    bars = bars || series.mark == Mark::bars;
  }
  Scale scale = scale_of(plot.x, values);
  if (bars && !scale.logarithmic && plot.x.categories.empty()) {  // half a bar more on either side
    std::erase_if(values, [](double x) { return !std::isfinite(x); });
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    double pitch = values.size() < 2 ? 1.0 : values.back() - values.front();
    for (std::size_t i = 1; i < values.size(); ++i) {
      pitch = std::min(pitch, values[i] - values[i - 1]);
    }
    if (!values.empty()) {
      if (!plot.x.low) scale.low = values.front() - 0.5 * pitch;
      if (!plot.x.high) scale.high = values.back() + 0.5 * pitch;
    }
  }
  return scale;
}

Scale y_scale_of(const Plot& plot) {
  std::vector<double> values;
  bool bars = false;
  for (const PlotSeries& series : plot.series) {
    for (const auto* list : {&series.y, &series.low, &series.high}) {
      values.insert(values.end(), list->begin(), list->end());
    }
    bars = bars || series.mark == Mark::bars;
  }
  for (const Reference& reference : plot.references) values.push_back(reference.y);
  return scale_of(plot.y, values, bars);
}

constexpr std::array<const char*, 3> kReferenceDashes = {"5 4", "1 3", "10 3"};

std::string reference_stroke(std::size_t index) {
  return fmt::format("stroke=\"#555\" stroke-width=\"1.5\" stroke-dasharray=\"{}\"",
                     kReferenceDashes[index % kReferenceDashes.size()]);
}

// PlotSeries are told apart by this name in <defs>; two plots on one page do not share it.
std::string hatching_name(const std::string& plot_name, std::size_t index) {
  return fmt::format("bar-{}-{}", plot_name, index);
}

SeriesStyle style_of(const Plot& plot, std::size_t series) {
  const int like = plot.series[series].like;
  return series_style(like < 0 ? static_cast<int>(series) : like);
}

std::vector<LegendEntry> legend_of(const Plot& plot, const std::string& plot_name) {
  std::vector<LegendEntry> legend;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const PlotSeries& series = plot.series[i];
    if (series.name.empty()) continue;
    legend.push_back(
        {series.name, legend_symbol(style_of(plot, i), series.mark, has_interval(series),
                                    hatching_name(plot_name, i))});
  }
  for (std::size_t i = 0; i < plot.references.size(); ++i) {
    legend.push_back(
        {plot.references[i].name, fmt::format("<path d=\"M0 6H28\" {}/>", reference_stroke(i))});
  }
  return legend;
}

std::string data_svg(const Plot& plot, const PlotArea& area, const std::string& plot_name) {
  std::string svg;
  for (std::size_t i = 0; i < plot.references.size(); ++i) {
    const double y = area.py(plot.references[i].y);
    if (!std::isfinite(y)) continue;
    svg += fmt::format("<path d=\"M{} {}H{}\" {}/>\n", coordinate(area.left), coordinate(y),
                       coordinate(area.right()), reference_stroke(i));
  }
  SidePlace place{.pitch = place_pitch(area, plot)};
  for (const PlotSeries& series : plot.series) place.slots += stands_aside(plot, series) ? 1 : 0;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const PlotSeries& series = plot.series[i];
    const bool aside = stands_aside(plot, series);
    svg += "<g class=\"series\">\n";
    svg += drawing_of(series, area, style_of(plot, i), aside ? place : SidePlace{},
                      hatching_name(plot_name, i));
    svg += "</g>\n";
    place.slot += aside ? 1 : 0;
  }
  return svg;
}

// Numbers that a logarithmic axis has no place for are not dropped in silence.
std::string said_of_hidden(const Plot& plot) {
  int hidden = 0;
  for (const PlotSeries& series : plot.series) {
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      const bool is_hidden =
          (plot.x.logarithmic && series.x[i] <= 0.0) || (plot.y.logarithmic && series.y[i] <= 0.0);
      hidden += is_hidden ? 1 : 0;
    }
  }
  if (hidden == 0) return "";
  return fmt::format("{}{} at 0 or below: not on a logarithmic axis",
                     plot.subtitle.empty() ? "" : "; ", hidden);
}

// Cuts off what lies outside the area, but not half a marker at its edge; by a picture in the
// picture, which needs no name.
std::string clipped(const PlotArea& area, const std::string& svg) {
  constexpr double kMarker = 5.0;  // [px] radius
  return fmt::format(
      "<svg x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" viewBox=\"{0} {1} {2} {3}\" "
      "overflow=\"hidden\">\n{4}</svg>\n",
      coordinate(area.left - kMarker), coordinate(area.top - kMarker),
      coordinate(area.width + 2 * kMarker), coordinate(area.height + 2 * kMarker), svg);
}

}  // namespace

std::string svg_of(const Plot& plot) {
  check(plot);
  const std::string subtitle = plot.subtitle + said_of_hidden(plot);
  const std::string name = fmt::format("{:x}", hash_of(plot.title + "\n" + csv_of(plot)));
  const FrameText text{.title = plot.title,
                       .subtitle = subtitle,
                       .legend = legend_of(plot, name),
                       .equal_scales = plot.equal_scales};
  const PlotFrame frame = frame_of(text, plot.x, plot.y, x_scale_of(plot), y_scale_of(plot));
  std::string patterns;
  bool any = false;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const PlotSeries& series = plot.series[i];
    if (series.mark == Mark::bars) {
      patterns += hatching_of(style_of(plot, i), hatching_name(name, i));
    }
    for (std::size_t k = 0; k < series.x.size(); ++k) {
      any = any || (std::isfinite(frame.area.px(series.x[k])) &&
                    std::isfinite(frame.area.py(series.y[k])));
    }
  }
  std::string content = patterns.empty() ? "" : "<defs>\n" + patterns + "</defs>\n";
  content += frame.head + frame.grid + clipped(frame.area, data_svg(plot, frame.area, name));
  content += frame.axes;
  if (!any) {
    content +=
        svg_text(frame.area.left + frame.area.width / 2, frame.area.top + frame.area.height / 2,
                 "no values", {kTextSize, "middle", "fill=\"#555\""});
  }
  return svg_file(frame.height, plot.title, content);
}

std::string csv_of(const Plot& plot) {
  check(plot);
  const auto place = [&](double x) {
    const auto index = static_cast<std::size_t>(std::max(0.0, x));
    const bool named = static_cast<double>(index) == x && index < plot.x.categories.size();
    return named ? plot.x.categories[index] : csv_number(x);
  };
  std::string text = csv_line({"series", title_of(plot.x), title_of(plot.y), "low", "high"});
  for (const PlotSeries& s : plot.series) {
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      text += csv_line({s.name, place(s.x[i]), csv_number(s.y[i]),
                        s.low.empty() ? "" : csv_number(s.low[i]),
                        s.high.empty() ? "" : csv_number(s.high[i])});
    }
  }
  for (const Reference& r : plot.references) {
    text += csv_line({r.name, "", csv_number(r.y), "", ""});
  }
  return text;
}

}  // namespace mapbed
