#include "bench/results/figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "bench/results/figure_parts.h"
#include "bench/results/result_folder.h"
#include "bench/results/series_figure.h"
#include "core/check.h"
#include "core/config/quantity.h"
#include "core/statistics/binomial.h"

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

// Where a matrix has what.
struct MatrixPlaces {
  std::vector<std::string> rows;
  std::vector<Matrix::Column> columns;
  std::map<std::pair<int, int>, std::size_t> cell_of;  // by level and variant
};

// Rows and columns of what is shown, in the order of the scenario; x may be no axis.
MatrixPlaces matrix_places(const Results& results, const PlotSpec& spec, int x, int y) {
  const auto text_at = [&](int axis, int level) -> std::string {
    if (axis < 0) return {};
    const auto index = static_cast<std::size_t>(axis);
    const int choice = results.levels[static_cast<std::size_t>(level)].choice[index];
    return results.axes[index].texts[static_cast<std::size_t>(choice)];
  };
  std::vector<std::pair<int, int>> shown;
  for (int level = 0; level < static_cast<int>(results.levels.size()); ++level) {
    for (int variant = 0; variant < static_cast<int>(results.variants.size()); ++variant) {
      if (is_shown(results, spec, level, variant)) shown.emplace_back(level, variant);
    }
  }
  MatrixPlaces places;
  const auto row_of = [&](int level) {
    return std::find(places.rows.begin(), places.rows.end(), text_at(y, level));
  };
  const auto column_of = [&](int level, int variant) {
    const std::string& name = results.variants[static_cast<std::size_t>(variant)];
    return std::find_if(places.columns.begin(), places.columns.end(), [&](const auto& column) {
      return column.group == text_at(x, level) && column.name == name;
    });
  };
  for (const auto& [level, variant] : shown) {
    if (row_of(level) == places.rows.end()) places.rows.push_back(text_at(y, level));
    if (column_of(level, variant) != places.columns.end()) continue;
    places.columns.push_back(
        {text_at(x, level), results.variants[static_cast<std::size_t>(variant)]});
  }
  std::stable_sort(places.columns.begin(), places.columns.end(), [&](const auto& a, const auto& b) {
    if (x < 0) return false;
    const auto& order = results.axes[static_cast<std::size_t>(x)].texts;
    return std::find(order.begin(), order.end(), a.group) <
           std::find(order.begin(), order.end(), b.group);
  });
  for (const auto& [level, variant] : shown) {
    const auto row = static_cast<std::size_t>(row_of(level) - places.rows.begin());
    const auto column =
        static_cast<std::size_t>(column_of(level, variant) - places.columns.begin());
    places.cell_of[{level, variant}] = row * places.columns.size() + column;
  }
  return places;
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
    const Interval interval = spec.is_binomial ? binomial_interval(row.mean, row.runs - row.missing)
                                               : Interval{row.low, row.high};
    series.low.push_back(displayed(interval.low, unit));
    series.high.push_back(displayed(interval.high, unit));
    counted.add(row);
  }
  const std::string drawn = mark == Mark::line ? "band" : "error bar";
  const std::string interval =
      spec.is_binomial ? "Wilson interval of the fraction" : "bootstrap interval of the mean";
  plot.subtitle = subtitle_of(
      spec, counted.runs_each("mean of {} runs each, " + drawn + ": 95 % " + interval), counted);
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

namespace {

void set_value_axis(const PlotSpec& spec, const std::string& metric, Unit unit, Matrix& matrix) {
  matrix.value = metric_axis(metric, unit, spec.value_label, spec.log_value);
  if (spec.value_range.empty()) return;
  const auto end = [&](std::size_t i) {
    return displayed(parse_quantity(spec.value_range[i], unit, spec.place), unit);
  };
  matrix.value.low = end(0);
  matrix.value.high = end(1);
}

// A row for each metric, a column for each variant.
Matrix matrix_of_metrics(const Results& results, const PlotSpec& spec) {
  Matrix matrix{.title = spec.title, .rows_label = "metric"};
  const auto metric_of = [&](const std::string& name) {
    return results.metrics[static_cast<std::size_t>(metric_index(results, name))];
  };
  set_value_axis(spec, spec.rows.front(), metric_of(spec.rows.front()).unit, matrix);
  std::map<int, std::size_t> column_of;  // by variant
  for (int variant = 0; variant < static_cast<int>(results.variants.size()); ++variant) {
    if (!is_shown(results, spec, variant)) continue;
    column_of[variant] = matrix.columns.size();
    matrix.columns.push_back({"", results.variants[static_cast<std::size_t>(variant)]});
  }
  matrix.values.assign(spec.rows.size() * matrix.columns.size(),
                       std::numeric_limits<double>::quiet_NaN());
  ShownRuns counted;
  for (const std::string& name : spec.rows) {
    for (const SummaryRow& row : results.summary) {
      if (row.metric != metric_index(results, name) || row.runs == 0 ||
          !is_shown(results, spec, row.level, row.variant)) {
        continue;
      }
      matrix.values[matrix.rows.size() * matrix.columns.size() + column_of.at(row.variant)] =
          displayed(row.mean, metric_of(name).unit);
      counted.add(row);
    }
    matrix.rows.push_back(words_of(name));
  }
  matrix.subtitle = subtitle_of(spec, counted.runs_each("mean of {} runs each"), counted);
  return matrix;
}

}  // namespace

Matrix matrix_of(const Results& results, const PlotSpec& spec) {
  if (!spec.rows.empty()) return matrix_of_metrics(results, spec);
  const int metric = metric_index(results, spec.value);
  const int mark = metric_index(results, spec.mark);
  const int x = axis_index(results, spec.x);
  const int y = axis_index(results, spec.y);
  CHECK(metric >= 0 && y >= 0);
  const Unit unit = results.metrics[static_cast<std::size_t>(metric)].unit;
  Matrix matrix{.title = spec.title, .rows_label = words_of(spec.y)};
  set_value_axis(spec, spec.value, unit, matrix);
  if (mark >= 0) matrix.mark_label = words_of(spec.mark);
  const MatrixPlaces places = matrix_places(results, spec, x, y);
  matrix.rows = places.rows;
  matrix.columns = places.columns;
  const std::size_t cells = matrix.rows.size() * matrix.columns.size();
  matrix.values.assign(cells, std::numeric_limits<double>::quiet_NaN());
  if (mark >= 0) matrix.marks.assign(cells, 0.0);
  ShownRuns counted;
  for (const SummaryRow& row : results.summary) {
    if (!is_shown(results, spec, row.level, row.variant) || row.runs == 0) continue;
    const auto place = places.cell_of.find({row.level, row.variant});
    if (place == places.cell_of.end()) continue;
    if (row.metric == mark) matrix.marks[place->second] = row.mean;
    if (row.metric != metric) continue;
    matrix.values[place->second] = displayed(row.mean, unit);
    counted.add(row);
  }
  matrix.subtitle = subtitle_of(spec, counted.runs_each("mean of {} runs each"), counted);
  return matrix;
}

std::vector<ResultFile> figure_files(const Results& results) {
  std::vector<ResultFile> files;
  const auto add = [&](const PlotSpec& spec, const auto& picture) {
    files.push_back({"figures/" + spec.file + ".svg", svg_of(picture)});
    files.push_back({"figures/" + spec.file + ".csv", csv_of(picture)});
  };
  for (const PlotSpec& spec : results.plots) {
    if (spec.kind == PlotKind::matrix) {
      const Matrix matrix = matrix_of(results, spec);
      if (!matrix.values.empty()) add(spec, matrix);
      continue;
    }
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
