#include "bench/results/figures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/results/figure_parts.h"
#include "bench/results/result_folder.h"
#include "bench/results/series_figure.h"
#include "core/check.h"
#include "core/config/quantity.h"

namespace mapbed {
namespace {

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
  plot.x = swept_axis(axis, spec.x_label, false);
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
    const auto& names = plot.x.categories;
    return static_cast<double>(std::find(names.begin(), names.end(), name) - names.begin());
  }
  const Level& at = results.levels[static_cast<std::size_t>(row.level)];
  const int choice = at.choice[static_cast<std::size_t>(x_axis)];
  const SweepAxis& axis = results.axes[static_cast<std::size_t>(x_axis)];
  return plot.x.categories.empty() ? axis.numbers[static_cast<std::size_t>(choice)] : choice;
}

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
  ShownRuns counted;
  for (const SummaryRow& row : results.summary) {
    if (row.metric != metric || !is_shown(results, spec, row.level, row.variant)) continue;
    if (row.runs == 0) continue;  // skipped
    PlotSeries& series =
        line_of(plot, line_name(results, spec, row.level, row.variant, x_axis), mark);
    series.x.push_back(place_of(results, plot, row, x_axis));
    series.y.push_back(displayed(row.mean, unit));
    series.low.push_back(displayed(row.low, unit));
    series.high.push_back(displayed(row.high, unit));
    counted.add(row);
  }
  const std::string interval = mark == Mark::line ? "band" : "error bar";
  plot.subtitle = subtitle_of(spec,
                              counted.runs_each("mean of {} runs each, " + interval +
                                                ": 95 % bootstrap interval of the mean"),
                              counted);
  if (counted.most <= 1) {
    for (PlotSeries& series : plot.series) series.low = series.high = {};
  }
}

void add_runs(const Results& results, const PlotSpec& spec, int metric, Plot& plot) {
  const int x_metric = metric_index(results, spec.x);
  const int x_axis = axis_index(results, spec.x);
  CHECK(x_metric >= 0 || x_axis >= 0);
  ShownRuns counted;
  for (const RunRow& run : results.runs) {
    if (!is_shown(results, spec, run.level, run.variant)) continue;
    const auto value = [&](int m) {
      return displayed(run.values[static_cast<std::size_t>(m)],
                       results.metrics[static_cast<std::size_t>(m)].unit);
    };
    const SummaryRow place{.level = run.level, .variant = run.variant};
    PlotSeries& series =
        line_of(plot, line_name(results, spec, run.level, run.variant, x_axis), Mark::points);
    series.x.push_back(x_metric >= 0 ? value(x_metric) : place_of(results, plot, place, x_axis));
    series.y.push_back(value(metric));
    ++counted.runs;
    counted.failed += run.failure.empty() ? 0 : 1;
    counted.missing += std::isnan(series.x.back() + series.y.back()) ? 1 : 0;
  }
  plot.subtitle = subtitle_of(spec, "a mark for each run", counted);
}

}  // namespace

Plot figure_of(const Results& results, const PlotSpec& spec) {
  if (spec.kind == PlotKind::series) return series_figure_of(results, spec);
  const int metric = metric_index(results, spec.y);
  CHECK(metric >= 0);
  Plot plot{.title = spec.title};
  const Metric& shown_metric = results.metrics[static_cast<std::size_t>(metric)];
  plot.y = metric_axis(shown_metric.name, shown_metric.unit, spec.y_label, spec.log_y);
  for (const PlotReference& reference : spec.references) {
    const double value = parse_quantity(reference.value, shown_metric.unit, spec.place);
    plot.references.push_back({reference.name, displayed(value, shown_metric.unit)});
  }
  const int x_metric = metric_index(results, spec.x);
  if (spec.kind == PlotKind::points && x_metric >= 0) {
    const Metric& along = results.metrics[static_cast<std::size_t>(x_metric)];
    plot.x = metric_axis(along.name, along.unit, spec.x_label, spec.log_x);
    add_runs(results, spec, metric, plot);
    return plot;
  }
  const int x_axis = spec.x.empty() ? kVariantsAlongX : axis_index(results, spec.x);
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
  const int metric = metric_index(results, spec.value);
  const int x = axis_index(results, spec.x);
  const int y = axis_index(results, spec.y);
  CHECK(metric >= 0 && x >= 0 && y >= 0);
  const Metric& shown_metric = results.metrics[static_cast<std::size_t>(metric)];
  const SweepAxis& columns = results.axes[static_cast<std::size_t>(x)];
  const SweepAxis& rows = results.axes[static_cast<std::size_t>(y)];
  HeatMap map{.title = spec.title, .xs = columns.numbers, .ys = rows.numbers};
  map.x = swept_axis(columns, spec.x_label, spec.log_x);
  map.y = swept_axis(rows, spec.y_label, spec.log_y);
  map.value = metric_axis(shown_metric.name, shown_metric.unit, spec.value_label, false);
  std::sort(map.xs.begin(), map.xs.end());
  std::sort(map.ys.begin(), map.ys.end());
  map.values.assign(map.xs.size() * map.ys.size(), std::numeric_limits<double>::quiet_NaN());
  ShownRuns counted;
  for (const SummaryRow& row : results.summary) {
    if (row.metric != metric || !is_shown(results, spec, row.level, row.variant)) continue;
    const std::size_t column = rank_of(results, row.level, x, map.xs);
    const std::size_t line = rank_of(results, row.level, y, map.ys);
    map.values[line * map.xs.size() + column] = displayed(row.mean, shown_metric.unit);
    counted.add(row);
  }
  map.subtitle = subtitle_of(spec, counted.runs_each("mean of {} runs each"), counted);
  return map;
}

std::vector<ResultFile> figure_files(const Results& results) {
  std::vector<ResultFile> files;
  const auto add = [&](const PlotSpec& spec, const auto& picture) {
    files.push_back({"figures/" + spec.file + ".svg", svg_of(picture)});
    files.push_back({"figures/" + spec.file + ".csv", csv_of(picture)});
  };
  for (const PlotSpec& spec : results.plots) {
    if (spec.kind != PlotKind::heat_map) {
      add(spec, figure_of(results, spec));
      continue;
    }
    const HeatMap map = heat_map_of(results, spec);
    if (map.xs.size() > 1 && map.ys.size() > 1) add(spec, map);
  }
  return files;
}

void write_figures(const std::string& folder, const Results& results) {
  write_files(folder, figure_files(results));
}

}  // namespace mapbed
