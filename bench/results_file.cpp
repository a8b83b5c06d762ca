#include "bench/results_file.h"

#include <fmt/format.h>

#include "bench/csv_file.h"
#include "core/config/quantity.h"

namespace mapbed {
namespace {

void append_axes(CsvRow& row, const Results& results, int level) {
  const Level& at = results.levels[static_cast<std::size_t>(level)];
  for (std::size_t axis = 0; axis < results.axes.size(); ++axis) {
    row.push_back(results.axes[axis].texts[static_cast<std::size_t>(at.choice[axis])]);
  }
}

void append_paths(CsvRow& row, const Results& results) {
  for (const SweepAxis& axis : results.axes) row.push_back(axis.path);
}

// "m" of "length [m]"; empty for a plain number.
std::string symbol_of(Unit unit) {
  const std::string name = unit_name(unit);
  const std::size_t open = name.find('[');
  return open == std::string::npos ? "" : name.substr(open + 1, name.size() - open - 2);
}

}  // namespace

std::string runs_csv(const Results& results) {
  CsvRow head{"run", "seed", "level"};
  append_paths(head, results);
  head.push_back("variant");
  for (const Metric& metric : results.metrics) head.push_back(metric.name);
  head.push_back("failure");
  std::string text = csv_line(head);
  for (const RunRow& run : results.runs) {
    CsvRow row{fmt::to_string(run.run), fmt::to_string(run.seed), fmt::to_string(run.level)};
    append_axes(row, results, run.level);
    row.push_back(results.variants[static_cast<std::size_t>(run.variant)]);
    for (const double value : run.values) row.push_back(csv_number(value));
    row.push_back(run.failure);
    text += csv_line(row);
  }
  return text;
}

std::string summary_csv(const Results& results) {
  CsvRow head{"level"};
  append_paths(head, results);
  for (const char* name : {"variant", "metric", "unit", "runs", "failed", "missing", "mean", "low",
                           "high", "median", "min", "max"}) {
    head.push_back(name);
  }
  std::string text = csv_line(head);
  for (const SummaryRow& s : results.summary) {
    const Metric& metric = results.metrics[static_cast<std::size_t>(s.metric)];
    CsvRow row{fmt::to_string(s.level)};
    append_axes(row, results, s.level);
    row.insert(row.end(), {results.variants[static_cast<std::size_t>(s.variant)], metric.name,
                           symbol_of(metric.unit), fmt::to_string(s.runs), fmt::to_string(s.failed),
                           fmt::to_string(s.missing)});
    for (const double value : {s.mean, s.low, s.high, s.median, s.min, s.max}) {
      row.push_back(csv_number(value));
    }
    text += csv_line(row);
  }
  return text;
}

std::string claims_csv(const Results& results) {
  std::string text = csv_line({"claim", "held", "measured", "thesis"});
  for (const ClaimResult& claim : results.claims) {
    text += csv_line({claim.claim, claim.held ? "yes" : "no", claim.measured, claim.thesis});
  }
  return text;
}

std::string cost_csv(const Results& results) {
  std::string text =
      csv_line({"run", "seconds", "recording_seconds", "recorded_seconds", "peak_memory_bytes"});
  for (const CostRow& cost : results.costs) {
    text += fmt::format("{},{:.6f},{:.6f},{:.6f},{:.0f}\n", cost.run, cost.seconds,
                        cost.recording_seconds, cost.recorded_seconds, cost.peak_memory);
  }
  return text;
}

}  // namespace mapbed
