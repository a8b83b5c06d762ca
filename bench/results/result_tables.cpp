#include "bench/results/result_tables.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "core/check.h"
#include "core/config/quantity.h"
#include "core/file/csv_file.h"
#include "core/file/tokens.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

const CsvRow kCostColumns{"run",
                          "seconds",
                          "recording_seconds",
                          "method_seconds",
                          "recorded_seconds",
                          "peak_memory_bytes",
                          "method_wall_seconds",
                          "program_memory_bytes"};
const CsvRow kSummaryColumns{"variant", "metric", "unit", "runs",   "failed", "missing",
                             "mean",    "low",    "high", "median", "min",    "max"};
const CsvRow kSeriesColumns{"run", "series", "x", "value"};
const CsvRow kVerdictColumns{"claim", "held", "measured", "thesis"};

void append(CsvRow& row, const CsvRow& more) {
  row.insert(row.end(), more.begin(), more.end());
}

void append_axes(CsvRow& row, const Results& results, int level) {
  const Level& at = results.levels[static_cast<std::size_t>(level)];
  for (std::size_t axis = 0; axis < results.axes.size(); ++axis) {
    row.push_back(results.axes[axis].texts[static_cast<std::size_t>(at.choice[axis])]);
  }
}

CsvRow paths_of(const Results& results) {
  CsvRow paths;
  for (const SweepAxis& axis : results.axes) paths.push_back(axis.path);
  return paths;
}

// Columns that say which run it is.
CsvRow run_columns(const Results& results) {
  CsvRow head{"run", "seed", "level"};
  append(head, paths_of(results));
  head.push_back("variant");
  return head;
}

CsvRow run_fields(const Results& results, const RunRow& run) {
  CsvRow row{fmt::to_string(run.run), fmt::to_string(run.seed), fmt::to_string(run.level)};
  append_axes(row, results, run.level);
  row.push_back(results.variants[static_cast<std::size_t>(run.variant)]);
  return row;
}

CsvRow head_of_runs(const Results& results) {
  CsvRow head = run_columns(results);
  for (const Metric& metric : results.metrics) head.push_back(metric.name);
  head.push_back("failure");
  return head;
}

CsvRow head_of_summary(const Results& results) {
  CsvRow head{"level"};
  append(head, paths_of(results));
  append(head, kSummaryColumns);
  return head;
}

// A table in memory, asked by the names of its columns.
class Table {
 public:
  Table(const std::string& name, std::string_view csv) : name_(name), rows_(parse_csv(name, csv)) {
    if (rows_.empty()) throw InputError({name}, "is empty");
  }

  std::size_t rows() const { return rows_.size() - 1; }
  const CsvRow& head() const { return rows_.front(); }
  const CsvRow& row(std::size_t i) const { return rows_[i + 1]; }
  SourceLocation place(std::size_t i) const { return {name_, static_cast<long>(i + 2)}; }

  void expect_head(const CsvRow& head) const {
    if (this->head() == head) return;
    throw InputError({name_, 1}, "these are not the columns of this table");
  }
  bool has(const std::string& column) const {
    return std::find(head().begin(), head().end(), column) != head().end();
  }
  const std::string& text(std::size_t i, const std::string& column) const {
    const auto found = std::find(head().begin(), head().end(), column);
    if (found == head().end()) throw InputError({name_, 1}, "has no column " + in_quotes(column));
    return row(i)[static_cast<std::size_t>(found - head().begin())];
  }
  double number(std::size_t i, const std::string& column) const {
    return parse_csv_number(text(i, column));
  }
  template <class Integer = int>
  Integer whole(std::size_t i, const std::string& column) const {
    const std::string& digits = text(i, column);
    Integer value{};
    if (parse_number(digits, value)) return value;
    throw InputError(place(i), in_quotes(digits) + " is not a whole number");
  }

 private:
  std::string name_;
  std::vector<CsvRow> rows_;
};

// Of an index that a plan's table has; -1 and numbers beyond the end are not of it.
int known(int index, std::size_t size, const SourceLocation& place) {
  if (index >= 0 && index < static_cast<int>(size)) return index;
  throw InputError(place, "this row is not of this scenario");
}

std::string verdicts_csv(const Results& results, bool of_cost) {
  std::string text = csv_line(kVerdictColumns);
  for (const Verdict& verdict : results.verdicts) {
    if (verdict.of_cost != of_cost) continue;
    text += csv_line({verdict.claim,
                      !verdict.judged ? "not judged"
                      : verdict.held  ? "yes"
                                      : "no",
                      verdict.measured, verdict.thesis});
  }
  return text;
}

// Not elsewhere: what a result lists is read, shown and removed with it.
bool is_below_a_folder(const std::string& path) {
  const std::filesystem::path normal = std::filesystem::path(path).lexically_normal();
  return !normal.empty() && normal.is_relative() && *normal.begin() != "..";
}

}  // namespace

std::string runs_csv(const Results& results) {
  std::string text = csv_line(head_of_runs(results));
  for (const RunRow& run : results.runs) {
    CsvRow row = run_fields(results, run);
    for (const double value : run.values) row.push_back(csv_number(value));
    row.push_back(run.failure);
    text += csv_line(row);
  }
  return text;
}

std::string summary_csv(const Results& results) {
  std::string text = csv_line(head_of_summary(results));
  for (const SummaryRow& s : results.summary) {
    const Metric& metric = results.metrics[static_cast<std::size_t>(s.metric)];
    CsvRow row{fmt::to_string(s.level)};
    append_axes(row, results, s.level);
    append(row, {results.variants[static_cast<std::size_t>(s.variant)], metric.name,
                 unit_symbol(metric.unit), fmt::to_string(s.runs), fmt::to_string(s.failed),
                 fmt::to_string(s.missing)});
    for (const double value : {s.mean, s.low, s.high, s.median, s.min, s.max}) {
      row.push_back(csv_number(value));
    }
    text += csv_line(row);
  }
  return text;
}

std::string series_csv(const Results& results) {
  if (results.series.empty()) return "";
  std::string text = csv_line(kSeriesColumns);
  for (const Series& series : results.series) {
    for (const SeriesPoint& point : series.points) {
      text += csv_line(
          {fmt::to_string(series.run), series.name, csv_number(point.x), csv_number(point.value)});
    }
  }
  return text;
}

std::string claims_csv(const Results& results) {
  return verdicts_csv(results, false);
}

std::string cost_claims_csv(const Results& results) {
  const bool has_some = std::any_of(results.verdicts.begin(), results.verdicts.end(),
                                    [](const Verdict& verdict) { return verdict.of_cost; });
  return has_some ? verdicts_csv(results, true) : "";
}

std::string cost_csv(const Results& results) {
  std::string text = csv_line(kCostColumns);
  for (const CostRow& cost : results.costs) {
    text +=
        fmt::format("{},{:.6f},{:.6f},{:.6f},{:.6f},{:.0f},{:.6f},{:.0f}\n", cost.run, cost.seconds,
                    cost.recording_seconds, cost.method_seconds, cost.recorded_seconds,
                    cost.peak_memory, cost.method_wall_seconds, cost.program_memory);
  }
  return text;
}

std::string files_csv(const Results& results) {
  if (results.files.empty()) return "";
  CsvRow head = run_columns(results);
  append(head, {"path", "title"});
  std::string text = csv_line(head);
  for (const FileOfRun& file : results.files) {
    const auto run = std::find_if(results.runs.begin(), results.runs.end(),
                                  [&](const RunRow& row) { return row.run == file.run; });
    CHECK(run != results.runs.end());
    CsvRow row = run_fields(results, *run);
    append(row, {file.path, file.title});
    text += csv_line(row);
  }
  return text;
}

std::vector<RunRow> parse_runs(const std::string& name, std::string_view csv, const Results& plan) {
  const Table table(name, csv);
  table.expect_head(head_of_runs(plan));
  std::vector<RunRow> runs;
  const std::size_t first = run_columns(plan).size();
  for (std::size_t i = 0; i < table.rows(); ++i) {
    RunRow& run = runs.emplace_back();
    run.run = table.whole(i, "run");
    run.seed = table.whole<std::uint64_t>(i, "seed");
    run.level = known(table.whole(i, "level"), plan.levels.size(), table.place(i));
    run.variant =
        known(variant_index(plan, table.row(i)[first - 1]), plan.variants.size(), table.place(i));
    for (std::size_t m = 0; m < plan.metrics.size(); ++m) {
      run.values.push_back(parse_csv_number(table.row(i)[first + m]));
    }
    run.failure = table.row(i).back();
  }
  return runs;
}

std::vector<SummaryRow> parse_summary(const std::string& name, std::string_view csv,
                                      const Results& plan) {
  const Table table(name, csv);
  table.expect_head(head_of_summary(plan));
  std::vector<SummaryRow> rows;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    SummaryRow& row = rows.emplace_back();
    const SourceLocation place = table.place(i);
    row.level = known(table.whole(i, "level"), plan.levels.size(), place);
    row.variant = known(variant_index(plan, table.text(i, "variant")), plan.variants.size(), place);
    row.metric = known(metric_index(plan, table.text(i, "metric")), plan.metrics.size(), place);
    row.runs = table.whole(i, "runs");
    row.failed = table.whole(i, "failed");
    row.missing = table.whole(i, "missing");
    row.mean = table.number(i, "mean");
    row.low = table.number(i, "low");
    row.high = table.number(i, "high");
    row.median = table.number(i, "median");
    row.min = table.number(i, "min");
    row.max = table.number(i, "max");
  }
  return rows;
}

std::vector<Series> parse_series(const std::string& name, std::string_view csv,
                                 const Results& plan) {
  const Table table(name, csv);
  table.expect_head(kSeriesColumns);
  std::vector<Series> all;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const int run = table.whole(i, "run");
    const std::string& series = table.text(i, "series");
    (void)known(series_index(plan, series), plan.series_metrics.size(), table.place(i));
    if (all.empty() || all.back().run != run || all.back().name != series) {
      all.push_back({.name = series, .points = {}, .run = run});
    }
    all.back().points.push_back({table.number(i, "x"), table.number(i, "value")});
  }
  return all;
}

std::vector<Verdict> parse_verdicts(const std::string& name, std::string_view csv, bool of_cost) {
  const Table table(name, csv);
  table.expect_head(kVerdictColumns);
  std::vector<Verdict> verdicts;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const std::string& held = table.text(i, "held");
    verdicts.push_back({.claim = table.text(i, "claim"),
                        .held = held == "yes",
                        .judged = held != "not judged",
                        .measured = table.text(i, "measured"),
                        .thesis = table.text(i, "thesis"),
                        .of_cost = of_cost});
  }
  return verdicts;
}

std::vector<CostRow> parse_costs(const std::string& name, std::string_view csv) {
  const Table table(name, csv);
  std::vector<CostRow> costs;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto number = [&](const std::string& column) {  // older results lack some
      return table.has(column) ? table.number(i, column) : 0.0;
    };
    costs.push_back({.run = table.whole(i, "run"),
                     .seconds = number("seconds"),
                     .recording_seconds = number("recording_seconds"),
                     .method_seconds = number("method_seconds"),
                     .recorded_seconds = number("recorded_seconds"),
                     .peak_memory = number("peak_memory_bytes"),
                     .method_wall_seconds = number("method_wall_seconds"),
                     .program_memory = number("program_memory_bytes")});
  }
  return costs;
}

std::vector<FileOfRun> parse_files(const std::string& name, std::string_view csv) {
  const Table table(name, csv);
  std::vector<FileOfRun> files;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const std::string& path = table.text(i, "path");
    if (!is_below_a_folder(path)) {
      throw InputError(table.place(i), in_quotes(path) + " is no path below the result's folder");
    }
    files.push_back({path, table.whole(i, "run"), table.text(i, "title")});
  }
  return files;
}

}  // namespace mapbed
