#include "bench/results/figures.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "bench/plot/svg_text.h"
#include "core/check.h"
#include "core/config/quantity.h"
#include "core/file/atomic_file.h"

namespace mapbed {
namespace {

constexpr int kVariantsAlongX = -2;  // in place of an axis' index

template <class Values, class Name>
int index_of(const Values& values, const std::string& name, Name name_of) {
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const auto& value) { return name_of(value) == name; });
  return found == values.end() ? -1 : static_cast<int>(found - values.begin());
}

int axis_of(const Results& results, const std::string& path) {
  return index_of(results.axes, path, [](const SweepAxis& axis) { return axis.path; });
}

int metric_of(const Results& results, const std::string& name) {
  return index_of(results.metrics, name, [](const Metric& metric) { return metric.name; });
}

// "rotation sigma" of "robot.odometry.rotation_sigma".
std::string words_of(const std::string& path) {
  std::string name = path.substr(path.rfind('.') + 1);
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

// People read degrees.
double shown(double value, Unit unit) {
  const bool angle = unit == Unit::radian || unit == Unit::radian_per_second;
  return angle ? value * 180.0 / std::numbers::pi : value;
}

std::string shown_unit(Unit unit) {
  if (unit == Unit::radian) return "deg";
  if (unit == Unit::radian_per_second) return "deg/s";
  const std::string name = unit_name(unit);
  const std::size_t open = name.find('[');
  return open == std::string::npos ? "" : name.substr(open + 1, name.size() - open - 2);
}

Axis metric_axis(const Metric& metric, const std::string& label, bool logarithmic) {
  return {label.empty() ? words_of(metric.name) : label, shown_unit(metric.unit), logarithmic};
}

Axis swept_axis(const SweepAxis& axis, const std::string& label, bool logarithmic) {
  return {label.empty() ? words_of(axis.path) : label, axis.unit, logarithmic};
}

bool is_shown(const Results& results, const PlotSpec& spec, int variant) {
  const bool was_run =
      results.skipped.empty() ||
      std::any_of(results.summary.begin(), results.summary.end(),
                  [&](const SummaryRow& row) { return row.variant == variant && row.runs > 0; });
  if (!was_run) return false;
  const std::string& name = results.variants[static_cast<std::size_t>(variant)];
  return spec.variants.empty() ||
         std::find(spec.variants.begin(), spec.variants.end(), name) != spec.variants.end();
}

// The values of an axis that the plot keeps to; null: all.
const std::vector<std::string>* values_at(const PlotSpec& spec, const std::string& path) {
  for (const auto& [of, values] : spec.at) {
    if (of == path) return &values;
  }
  return nullptr;
}

bool is_shown(const Results& results, const PlotSpec& spec, int level, int variant) {
  const Level& at = results.levels[static_cast<std::size_t>(level)];
  for (std::size_t i = 0; i < results.axes.size(); ++i) {
    const std::vector<std::string>* values = values_at(spec, results.axes[i].path);
    if (values == nullptr) continue;
    const std::string& value = results.axes[i].texts[static_cast<std::size_t>(at.choice[i])];
    if (std::find(values->begin(), values->end(), value) == values->end()) return false;
  }
  return is_shown(results, spec, variant);
}

// What makes one series: the variant and the values of all axes but that along x and those of
// which one value is shown.
std::string series_name(const Results& results, const PlotSpec& spec, int level, int variant,
                        int x_axis) {
  std::string name = results.variants.size() > 1 && x_axis != kVariantsAlongX
                         ? results.variants[static_cast<std::size_t>(variant)]
                         : "";
  const Level& at = results.levels[static_cast<std::size_t>(level)];
  for (std::size_t axis = 0; axis < results.axes.size(); ++axis) {
    const SweepAxis& swept = results.axes[axis];
    const std::vector<std::string>* values = values_at(spec, swept.path);
    const bool is_one = values != nullptr && values->size() == 1;
    if (static_cast<int>(axis) == x_axis || is_one) continue;
    name += (name.empty() ? "" : ", ") + words_of(swept.path) + " " +
            swept.texts[static_cast<std::size_t>(at.choice[axis])];
  }
  return name;
}

PlotSeries& series_of(Plot& plot, const std::string& name, Mark mark) {
  for (PlotSeries& series : plot.series) {
    if (series.name == name) return series;
  }
  plot.series.push_back({.name = name, .mark = mark});
  return plot.series.back();
}

void set_x_axis(const Results& results, const PlotSpec& spec, int x_axis, Plot& plot) {
  if (x_axis == kVariantsAlongX) {
    plot.x.label = spec.x_label;
    for (std::size_t i = 0; i < results.variants.size(); ++i) {
      if (is_shown(results, spec, static_cast<int>(i))) {
        plot.x.categories.push_back(results.variants[i]);
      }
    }
    return;
  }
  const SweepAxis& axis = results.axes[static_cast<std::size_t>(x_axis)];
  plot.x.label = spec.x_label.empty() ? words_of(axis.path) : spec.x_label;
  plot.x.unit = axis.unit;
  // Bars of numbers that are not evenly spaced stand side by side all the same.
  if (axis.numbers.empty() || (spec.kind == PlotKind::bars && !spec.log_x)) {
    plot.x.categories = axis.texts;
    plot.x.unit.clear();
  } else {
    plot.x.logarithmic = spec.log_x;
  }
}

double place_of(const Results& results, const Plot& plot, const SummaryRow& row, int x_axis) {
  if (x_axis == kVariantsAlongX) {
    const std::string& name = results.variants[static_cast<std::size_t>(row.variant)];
    return index_of(plot.x.categories, name, [](const std::string& text) { return text; });
  }
  const Level& at = results.levels[static_cast<std::size_t>(row.level)];
  const int choice = at.choice[static_cast<std::size_t>(x_axis)];
  const SweepAxis& axis = results.axes[static_cast<std::size_t>(x_axis)];
  return plot.x.categories.empty() ? axis.numbers[static_cast<std::size_t>(choice)] : choice;
}

std::string said_of(const PlotSpec& spec, const std::string& treatment, int runs, int failed,
                    int missing) {
  std::string text = treatment;
  for (const auto& [path, values] : spec.at) {
    if (values.size() == 1) text += "; " + words_of(path) + " " + values.front();
  }
  if (failed > 0) text += fmt::format("; {} of {} runs failed", failed, runs);
  if (missing > 0) text += fmt::format("; {} without a value left out", missing);
  if (!spec.thesis.empty()) text += "; beside " + spec.thesis;
  return text;
}

// The runs behind a picture of the summary.
struct Shown {
  int runs = 0, failed = 0, missing = 0;
  int least = std::numeric_limits<int>::max(), most = 0;  // of one place

  void add(const SummaryRow& row) {
    runs += row.runs;
    failed += row.failed;
    missing += row.missing;
    least = std::min(least, row.runs);
    most = std::max(most, row.runs);
  }
  // `several` with the number, "10" or "8 to 10", in place of its braces.
  std::string runs_each(const std::string& several) const {
    if (most <= 1) return "one run each";
    const std::string count =
        least >= most ? fmt::to_string(most) : fmt::format("{} to {}", least, most);
    return fmt::format(fmt::runtime(several), count);
  }
};

// Of the level's value along an axis among all of them, which are sorted.
std::size_t rank_of(const Results& results, int level, int axis,
                    const std::vector<double>& sorted) {
  const Level& at = results.levels[static_cast<std::size_t>(level)];
  const auto choice = static_cast<std::size_t>(at.choice[static_cast<std::size_t>(axis)]);
  const double number = results.axes[static_cast<std::size_t>(axis)].numbers[choice];
  return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), number) -
                                  sorted.begin());
}

void add_means(const Results& results, const PlotSpec& spec, int metric, int x_axis, Plot& plot) {
  const Unit unit = results.metrics[static_cast<std::size_t>(metric)].unit;
  // Between names there is nothing that a line could pass through.
  const bool names = !plot.x.categories.empty();
  const Mark mark = spec.kind == PlotKind::bars && !spec.log_y ? Mark::bars
                    : names || spec.kind == PlotKind::bars     ? Mark::points
                                                               : Mark::line;
  Shown counted;
  for (const SummaryRow& row : results.summary) {
    if (row.metric != metric || !is_shown(results, spec, row.level, row.variant)) continue;
    if (row.runs == 0) continue;  // skipped
    PlotSeries& series =
        series_of(plot, series_name(results, spec, row.level, row.variant, x_axis), mark);
    series.x.push_back(place_of(results, plot, row, x_axis));
    series.y.push_back(shown(row.mean, unit));
    series.low.push_back(shown(row.low, unit));
    series.high.push_back(shown(row.high, unit));
    counted.add(row);
  }
  const std::string interval = mark == Mark::line ? "band" : "error bar";
  plot.subtitle = said_of(spec,
                          counted.runs_each("mean of {} runs each, " + interval +
                                            ": 95 % bootstrap interval of the mean"),
                          counted.runs, counted.failed, counted.missing);
  if (counted.most <= 1) {
    for (PlotSeries& series : plot.series) series.low = series.high = {};
  }
}

void add_runs(const Results& results, const PlotSpec& spec, int metric, Plot& plot) {
  const int x_metric = metric_of(results, spec.x);
  const int x_axis = axis_of(results, spec.x);
  CHECK(x_metric >= 0 || x_axis >= 0);
  int failed = 0, missing = 0, shown_runs = 0;
  for (const RunRow& run : results.runs) {
    if (!is_shown(results, spec, run.level, run.variant)) continue;
    const auto value = [&](int m) {
      return shown(run.values[static_cast<std::size_t>(m)],
                   results.metrics[static_cast<std::size_t>(m)].unit);
    };
    const SummaryRow place{.level = run.level, .variant = run.variant};
    PlotSeries& series =
        series_of(plot, series_name(results, spec, run.level, run.variant, x_axis), Mark::points);
    series.x.push_back(x_metric >= 0 ? value(x_metric) : place_of(results, plot, place, x_axis));
    series.y.push_back(value(metric));
    ++shown_runs;
    failed += run.failure.empty() ? 0 : 1;
    missing += std::isnan(series.x.back() + series.y.back()) ? 1 : 0;
  }
  plot.subtitle = said_of(spec, "a mark for each run", shown_runs, failed, missing);
}

}  // namespace

Plot figure_of(const Results& results, const PlotSpec& spec) {
  const int metric = metric_of(results, spec.y);
  CHECK(metric >= 0);
  Plot plot{.title = spec.title};
  const Metric& shown_metric = results.metrics[static_cast<std::size_t>(metric)];
  plot.y = metric_axis(shown_metric, spec.y_label, spec.log_y);
  for (const PlotReference& reference : spec.references) {
    const double value = parse_quantity(reference.value, shown_metric.unit, spec.place);
    plot.references.push_back({reference.name, shown(value, shown_metric.unit)});
  }
  const int x_metric = metric_of(results, spec.x);
  if (spec.kind == PlotKind::points && x_metric >= 0) {
    plot.x =
        metric_axis(results.metrics[static_cast<std::size_t>(x_metric)], spec.x_label, spec.log_x);
    add_runs(results, spec, metric, plot);
    return plot;
  }
  const int x_axis = spec.x.empty() ? kVariantsAlongX : axis_of(results, spec.x);
  CHECK(x_axis != -1);
  set_x_axis(results, spec, x_axis, plot);
  if (spec.kind == PlotKind::points && x_axis >= 0) {
    add_runs(results, spec, metric, plot);
  } else {
    add_means(results, spec, metric, x_axis, plot);
  }
  return plot;
}

HeatMap heat_map_of(const Results& results, const PlotSpec& spec) {
  const int metric = metric_of(results, spec.value);
  const int x = axis_of(results, spec.x);
  const int y = axis_of(results, spec.y);
  CHECK(metric >= 0 && x >= 0 && y >= 0);
  const Metric& shown_metric = results.metrics[static_cast<std::size_t>(metric)];
  const SweepAxis& columns = results.axes[static_cast<std::size_t>(x)];
  const SweepAxis& rows = results.axes[static_cast<std::size_t>(y)];
  HeatMap map{.title = spec.title, .xs = columns.numbers, .ys = rows.numbers};
  map.x = swept_axis(columns, spec.x_label, spec.log_x);
  map.y = swept_axis(rows, spec.y_label, spec.log_y);
  map.value = metric_axis(shown_metric, spec.value_label, false);
  std::sort(map.xs.begin(), map.xs.end());
  std::sort(map.ys.begin(), map.ys.end());
  map.values.assign(map.xs.size() * map.ys.size(), std::numeric_limits<double>::quiet_NaN());
  Shown counted;
  for (const SummaryRow& row : results.summary) {
    if (row.metric != metric || !is_shown(results, spec, row.level, row.variant)) continue;
    const std::size_t column = rank_of(results, row.level, x, map.xs);
    const std::size_t line = rank_of(results, row.level, y, map.ys);
    map.values[line * map.xs.size() + column] = shown(row.mean, shown_metric.unit);
    counted.add(row);
  }
  map.subtitle = said_of(spec, counted.runs_each("mean of {} runs each"), counted.runs,
                         counted.failed, counted.missing);
  return map;
}

void write_figures(const std::string& folder, const Results& results) {
  if (results.plots.empty()) return;
  const std::filesystem::path figures = std::filesystem::path(folder) / "figures";
  std::filesystem::create_directories(figures);
  const auto write = [&](const PlotSpec& spec, const auto& picture) {
    write_file((figures / (spec.file + ".svg")).string(), svg_of(picture));
    write_file((figures / (spec.file + ".csv")).string(), csv_of(picture));
  };
  for (const PlotSpec& spec : results.plots) {
    if (spec.kind != PlotKind::heat_map) {
      write(spec, figure_of(results, spec));
      continue;
    }
    const HeatMap map = heat_map_of(results, spec);
    if (map.xs.size() > 1 && map.ys.size() > 1) write(spec, map);
  }
}

}  // namespace mapbed
