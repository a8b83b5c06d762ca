#include "bench/results/results_file.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include <fmt/format.h>

#include "bench/results/summary.h"
#include "bench/scenario/config_text.h"
#include "core/config/quantity.h"
#include "core/file/csv_file.h"
#include "core/file/text_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

const CsvRow kCostColumns{"run",
                          "seconds",
                          "recording_seconds",
                          "method_seconds",
                          "recorded_seconds",
                          "peak_memory_bytes"};

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

CsvRow head_of_runs(const Results& results) {
  CsvRow head{"run", "seed", "level"};
  append_paths(head, results);
  head.push_back("variant");
  for (const Metric& metric : results.metrics) head.push_back(metric.name);
  head.push_back("failure");
  return head;
}

template <class Integer>
Integer whole_number(const std::string& text, const SourceLocation& place) {
  Integer value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size()) return value;
  throw InputError(place, in_quotes(text) + " is not a whole number");
}

RunRow run_of(const CsvRow& row, const Results& plan, const SourceLocation& place) {
  RunRow run{.run = whole_number<int>(row[0], place), .level = whole_number<int>(row[2], place)};
  run.seed = whole_number<std::uint64_t>(row[1], place);
  const std::size_t at = 3 + plan.axes.size();
  const auto variant = std::find(plan.variants.begin(), plan.variants.end(), row[at]);
  const bool has_level = run.level >= 0 && run.level < static_cast<int>(plan.levels.size());
  if (variant == plan.variants.end() || !has_level) {
    throw InputError(place, "this run is not of this scenario");
  }
  run.variant = static_cast<int>(variant - plan.variants.begin());
  for (std::size_t m = 0; m < plan.metrics.size(); ++m) {
    run.values.push_back(parse_csv_number(row[at + 1 + m]));
  }
  run.failure = row.back();
  return run;
}

std::vector<CsvRow> rows_of(const std::string& path, std::size_t fields) {
  std::vector<CsvRow> rows = parse_csv(path, read_text_file(path));
  if (rows.empty() || rows.front().size() != fields) {
    throw InputError({path, 1}, "these are not the columns of this table");
  }
  rows.erase(rows.begin());
  return rows;
}

// By the columns' names: older results lack some.
std::vector<CostRow> costs_of(const std::string& path) {
  const std::vector<CsvRow> rows = parse_csv(path, read_text_file(path));
  if (rows.empty() || rows.front().front() != "run") {
    throw InputError({path, 1}, "these are not the columns of this table");
  }
  std::vector<CostRow> costs;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto number = [&](const std::string& name) {
      const auto column = std::find(rows.front().begin(), rows.front().end(), name);
      if (column == rows.front().end()) return 0.0;
      return parse_csv_number(rows[i][static_cast<std::size_t>(column - rows.front().begin())]);
    };
    costs.push_back({.run = whole_number<int>(rows[i][0], {path, static_cast<long>(i + 1)}),
                     .seconds = number("seconds"),
                     .recording_seconds = number("recording_seconds"),
                     .method_seconds = number("method_seconds"),
                     .recorded_seconds = number("recorded_seconds"),
                     .peak_memory = number("peak_memory_bytes")});
  }
  return costs;
}

std::string verdicts_csv(const Results& results, bool of_cost) {
  std::string text = csv_line({"claim", "held", "measured", "thesis"});
  for (const ClaimResult& claim : results.claims) {
    if (claim.of_cost != of_cost) continue;
    text += csv_line({claim.claim,
                      !claim.judged ? "not judged"
                      : claim.held  ? "yes"
                                    : "no",
                      claim.measured, claim.thesis});
  }
  return text;
}

void add_claims(const std::string& path, bool of_cost, Results& results) {
  for (const CsvRow& row : rows_of(path, 4)) {
    results.claims.push_back({.claim = row[0],
                              .held = row[1] == "yes",
                              .judged = row[1] != "not judged",
                              .measured = row[2],
                              .thesis = row[3],
                              .of_cost = of_cost});
  }
}

}  // namespace

std::string runs_csv(const Results& results) {
  std::string text = csv_line(head_of_runs(results));
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
  return verdicts_csv(results, false);
}

std::string cost_claims_csv(const Results& results) {
  const bool has_some = std::any_of(results.claims.begin(), results.claims.end(),
                                    [](const ClaimResult& claim) { return claim.of_cost; });
  return has_some ? verdicts_csv(results, true) : "";
}

std::string cost_csv(const Results& results) {
  std::string text = csv_line(kCostColumns);
  for (const CostRow& cost : results.costs) {
    text += fmt::format("{},{:.6f},{:.6f},{:.6f},{:.6f},{:.0f}\n", cost.run, cost.seconds,
                        cost.recording_seconds, cost.method_seconds, cost.recorded_seconds,
                        cost.peak_memory);
  }
  return text;
}

std::vector<RunRow> parse_runs(const std::string& name, std::string_view csv, const Results& plan) {
  const std::vector<CsvRow> rows = parse_csv(name, csv);
  if (rows.empty() || rows.front() != head_of_runs(plan)) {
    throw InputError({name, 1}, "these are not the columns of this scenario's runs");
  }
  std::vector<RunRow> runs;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    runs.push_back(run_of(rows[i], plan, {name, static_cast<long>(i + 1)}));
  }
  return runs;
}

Results load_results(const std::string& folder) {
  Results results = load_planned(folder + "/config.yaml");
  const std::string runs = folder + "/runs.csv";
  results.runs = parse_runs(runs, read_text_file(runs), results);
  results.summary = summarise(results);
  add_claims(folder + "/claims.csv", false, results);
  const std::string cost_claims = folder + "/cost_claims.csv";
  if (std::filesystem::exists(cost_claims)) add_claims(cost_claims, true, results);
  results.costs = costs_of(folder + "/cost.csv");
  return results;
}

}  // namespace mapbed
