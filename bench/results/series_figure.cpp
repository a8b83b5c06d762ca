#include "bench/results/series_figure.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "bench/results/figure_parts.h"
#include "bench/results/series_claims.h"
#include "core/check.h"
#include "core/config/quantity.h"
#include "core/statistics/bootstrap.h"
#include "core/statistics/moments.h"

namespace mapbed {
namespace {

constexpr std::size_t kMostPlaces = 100;  // along x; finer than that nobody sees

using SeriesOfRuns = std::vector<const Series*>;

// Where the mean is taken: at the points themselves where all runs have the same ones, else at
// even steps, as the runs' times differ.
std::vector<double> places_of(const SeriesOfRuns& all) {
  std::vector<double> places;
  std::size_t longest = 0;
  for (const Series* series : all) {
    longest = std::max(longest, series->points.size());
    for (const SeriesPoint& point : series->points) places.push_back(point.x);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  if (places.size() == longest || places.empty()) return places;
  const double first = places.front();
  const double span = places.back() - first;
  places.assign(std::min(longest, kMostPlaces), first + span);
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    places[i] = first + span * static_cast<double>(i) / static_cast<double>(places.size() - 1);
  }
  return places;
}

// Gives the number of runs that end before the others do.
int draw(const SeriesOfRuns& all, const SeriesMetric& metric, PlotSeries& line) {
  const std::vector<double> places = places_of(all);
  for (const double x : places) {
    std::vector<double> values;
    for (const Series* series : all) {
      const double value = value_at(*series, metric, x);
      if (!std::isnan(value)) values.push_back(value);
    }
    if (values.empty()) continue;
    const Interval interval = bootstrap_interval(values);
    line.x.push_back(displayed(x, metric.x_unit));
    line.y.push_back(displayed(mean_of(values), metric.unit));
    line.low.push_back(displayed(interval.low, metric.unit));
    line.high.push_back(displayed(interval.high, metric.unit));
  }
  return static_cast<int>(std::count_if(all.begin(), all.end(), [&](const Series* series) {
    return series->points.back().x < places.back();
  }));
}

// The runs of a level and variant, and those series of theirs that there are.
struct LineData {
  SummaryRow row;
  SeriesOfRuns series;
};

// By level and variant, the last one fastest; no runs where the plot shows none.
std::vector<LineData> lines_in(const Results& results, const PlotSpec& spec) {
  std::map<int, const Series*> by_run;
  for (const Series& series : results.series) {
    if (series.name == spec.y && !series.points.empty()) by_run[series.run] = &series;
  }
  const std::size_t variants = results.variants.size();
  std::vector<LineData> lines(results.levels.size() * variants);
  for (const RunRow& run : results.runs) {
    if (!is_shown(results, spec, run.level, run.variant)) continue;
    LineData& line = lines[static_cast<std::size_t>(run.level) * variants +
                           static_cast<std::size_t>(run.variant)];
    line.row.level = run.level;
    line.row.variant = run.variant;
    ++line.row.runs;
    line.row.failed += run.failure.empty() ? 0 : 1;
    const auto found = by_run.find(run.run);
    if (found == by_run.end()) {
      ++line.row.missing;
    } else {
      line.series.push_back(found->second);
    }
  }
  return lines;
}

}  // namespace

Plot series_figure_of(const Results& results, const PlotSpec& spec) {
  const int index = series_index(results, spec.y);
  CHECK(index >= 0);
  const SeriesMetric& metric = results.series_metrics[static_cast<std::size_t>(index)];
  Plot plot{.title = spec.title};
  plot.x = metric_axis(metric.x_name, metric.x_unit, spec.x_label, spec.log_x);
  plot.y = metric_axis(metric.name, metric.unit, spec.y_label, spec.log_y);
  for (const PlotReference& reference : spec.references) {
    const double value = parse_quantity(reference.value, metric.unit, spec.place);
    plot.references.push_back({reference.name, displayed(value, metric.unit)});
  }
  ShownRuns counted;
  int short_runs = 0;
  for (const auto& [row, series] : lines_in(results, spec)) {
    if (row.runs == 0) continue;
    counted.add(row);
    if (series.empty()) continue;
    PlotSeries& line =
        line_of(plot, line_name(results, spec, row.level, row.variant, -1), Mark::line);
    short_runs += draw(series, metric, line);
    if (row.runs <= 1) line.low = line.high = {};
  }
  std::string treatment =
      counted.runs_each("mean of {} runs each, band: 95 % bootstrap interval of the mean");
  if (short_runs > 0) {
    treatment += fmt::format("; {} runs end earlier than others{}", short_runs,
                             stays_where_it_ends(metric) ? " and count with their last value" : "");
  }
  plot.subtitle = subtitle_of(spec, treatment, counted);
  return plot;
}

}  // namespace mapbed
