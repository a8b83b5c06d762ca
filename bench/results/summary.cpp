#include "bench/results/summary.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/statistics/bootstrap.h"
#include "core/statistics/moments.h"
#include "core/statistics/quantile.h"

namespace mapbed {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

void fill_in(SummaryRow& row, std::vector<double> values) {
  if (values.empty()) {
    row.mean = row.low = row.high = row.median = row.min = row.max = kNone;
    return;
  }
  row.mean = mean_of(values);
  const Interval interval = bootstrap_interval(values);
  row.low = interval.low;
  row.high = interval.high;
  std::sort(values.begin(), values.end());
  row.median = median_of(values);
  row.min = values.front();
  row.max = values.back();
}

}  // namespace

std::vector<SummaryRow> summary_of(const Results& results) {
  const std::size_t variants = results.variants.size();
  const std::size_t metrics = results.metrics.size();
  std::vector<SummaryRow> rows(results.levels.size() * variants * metrics);
  std::vector<std::vector<double>> values(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].level = static_cast<int>(i / (variants * metrics));
    rows[i].variant = static_cast<int>(i / metrics % variants);
    rows[i].metric = static_cast<int>(i % metrics);
  }
  for (const RunRow& run : results.runs) {
    const std::size_t first =
        (static_cast<std::size_t>(run.level) * variants + static_cast<std::size_t>(run.variant)) *
        metrics;
    for (std::size_t m = 0; m < metrics; ++m) {
      SummaryRow& row = rows[first + m];
      ++row.runs;
      if (!run.failure.empty()) ++row.failed;
      if (std::isnan(run.values[m])) {
        ++row.missing;
      } else {
        values[first + m].push_back(run.values[m]);
      }
    }
  }
  for (std::size_t i = 0; i < rows.size(); ++i) fill_in(rows[i], std::move(values[i]));
  return rows;
}

}  // namespace mapbed
