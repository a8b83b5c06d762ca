#include "bench/results/summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/random.h"

namespace mapbed {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kResamples = 2000;
constexpr std::uint64_t kBootstrapSeed = 2012;

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double median_of(const std::vector<double>& sorted) {
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2.0;
}

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

Interval bootstrap_interval(std::span<const double> values) {
  if (values.size() < 2) return {kNone, kNone};
  Rng rng = Rng(kBootstrapSeed).stream("bootstrap");
  std::vector<double> means(kResamples);
  for (double& mean : means) {
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) sum += values[rng.index(values.size())];
    mean = sum / static_cast<double>(values.size());
  }
  std::sort(means.begin(), means.end());
  return {means[kResamples / 40], means[kResamples - 1 - kResamples / 40]};
}

std::vector<SummaryRow> summarise(const Results& results) {
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
