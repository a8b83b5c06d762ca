#include "bench/results/series_claims.h"

#include <algorithm>
#include <limits>

#include "bench/results/summary.h"
#include "core/config/quantity.h"

namespace mapbed {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// The claim's word on x of its series; the end of claim.at where there is none.
auto place_in_series(const Claim& claim, const Results& plan) {
  const int series = series_index(plan, claim.metric);
  return std::find_if(claim.at.begin(), claim.at.end(), [&](const auto& at) {
    return series >= 0 && at.first == plan.series_metrics[static_cast<std::size_t>(series)].x_name;
  });
}

double x_of(const Claim& claim, const Results& plan) {
  const auto place = place_in_series(claim, plan);
  if (claim.take != Claim::Take::at || place == claim.at.end()) return kNone;
  const int series = series_index(plan, claim.metric);
  return parse_quantity(place->second, plan.series_metrics[static_cast<std::size_t>(series)].x_unit,
                        claim.place);
}

double taken(const Series& series, const SeriesMetric& metric, Claim::Take take, double x) {
  if (series.points.empty()) return kNone;
  switch (take) {
    case Claim::Take::first:
      return series.points.front().value;
    case Claim::Take::last:
      return series.points.back().value;
    case Claim::Take::at:
      return value_at(series, metric, x);
  }
  return kNone;
}

}  // namespace

void check_taken_value(const Claim& claim, const Results& plan) {
  const auto x_name = [&](const std::string& series) {
    return plan.series_metrics[static_cast<std::size_t>(series_index(plan, series))].x_name;
  };
  const std::string x = x_name(claim.metric);
  const bool has_place = place_in_series(claim, plan) != claim.at.end();
  if (claim.take == Claim::Take::at && !has_place) {
    throw InputError(claim.place,
                     "the claim does not say which value of the series " + in_quotes(claim.metric) +
                         " it is about",
                     "add 'take: first', 'take: last' or 'at: {" + x + ": …}'");
  }
  if (claim.take != Claim::Take::at && has_place) {
    throw InputError(claim.place, "the claim takes two values of one series",
                     "leave out 'take' or " + in_quotes(x));
  }
  (void)x_of(claim, plan);
  if (claim.take == Claim::Take::at && !claim.against_metric.empty() &&
      x_name(claim.against_metric) != x) {
    throw InputError(claim.place, in_quotes(claim.against_metric) + " does not go over " + x,
                     "compare two series over the same");
  }
}

Claim as_metric_claim(Claim claim, const Results& plan) {
  const auto place = place_in_series(claim, plan);
  if (place != claim.at.end()) claim.at.erase(place);
  claim.is_series = false;
  return claim;
}

Results with_series_as_metrics(const Results& results, const Claim& claim) {
  Results taken_values = results;
  taken_values.metrics.clear();
  for (const SeriesMetric& metric : results.series_metrics) {
    taken_values.metrics.push_back({metric.name, metric.unit, metric.about});
  }
  const double x = x_of(claim, results);
  for (RunRow& run : taken_values.runs) {
    run.values.assign(taken_values.metrics.size(), kNone);
    for (const Series& series : results.series) {
      const int index = series.run == run.run ? series_index(results, series.name) : -1;
      if (index < 0) continue;
      const SeriesMetric& metric = results.series_metrics[static_cast<std::size_t>(index)];
      run.values[static_cast<std::size_t>(index)] = taken(series, metric, claim.take, x);
    }
  }
  taken_values.summary = summary_of(taken_values);
  return taken_values;
}

double value_at(const Series& series, const SeriesMetric& metric, double x) {
  const std::vector<SeriesPoint>& points = series.points;
  const auto next = std::lower_bound(points.begin(), points.end(), x,
                                     [](const SeriesPoint& p, double at) { return p.x < at; });
  if (next == points.end()) {
    return points.empty() || !stays_where_it_ends(metric) ? kNone : points.back().value;
  }
  if (next->x == x) return next->value;
  if (next == points.begin()) return kNone;
  const SeriesPoint& before = *(next - 1);
  const double fraction = (x - before.x) / (next->x - before.x);
  return before.value + fraction * (next->value - before.value);
}

}  // namespace mapbed
