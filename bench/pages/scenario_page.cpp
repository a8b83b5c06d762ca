#include "bench/pages/scenario_page.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "bench/pages/html.h"
#include "bench/pages/pictures_html.h"
#include "bench/plot/axis.h"
#include "bench/plot/svg_text.h"
#include "core/config/quantity.h"
#include "core/file/csv_file.h"

namespace mapbed {
namespace {

std::string section(const std::string& title, const std::string& html) {
  return html.empty() ? "" : "<section>\n<h2>" + title + "</h2>\n" + html + "</section>\n";
}

std::string skipped_html(const Results& results) {
  std::string html;
  for (const std::string& line : results.skipped) {
    html += "<p class=\"note\">Left out: " + xml_escaped(line) + ".</p>\n";
  }
  return html;
}

HtmlCell interval_cell(const SummaryRow& row, Unit unit) {
  if (std::isnan(row.low) || std::isnan(row.high)) return {"\u2013", "", true};
  const double low = displayed(row.low, unit);
  return {number_text(low, 4) + " to " + number_text(displayed(row.high, unit), 4), csv_number(low),
          true};
}

// A line of the table of numbers as people read it: angles in degrees.
std::vector<HtmlCell> summary_cells(const Results& results, const SummaryRow& row) {
  const Metric& metric = results.metrics[static_cast<std::size_t>(row.metric)];
  const Level& level = results.levels[static_cast<std::size_t>(row.level)];
  std::vector<HtmlCell> cells;
  for (std::size_t i = 0; i < results.axes.size(); ++i) {
    cells.push_back(text_cell(results.axes[i].texts[static_cast<std::size_t>(level.choice[i])]));
  }
  cells.push_back(text_cell(results.variants[static_cast<std::size_t>(row.variant)]));
  cells.push_back(text_cell(words_of(metric.name)));
  cells.push_back(text_cell(display_symbol(metric.unit)));
  for (const int count : {row.runs, row.failed, row.missing}) {
    cells.push_back(number_cell(count, 9));
  }
  cells.push_back(number_cell(displayed(row.mean, metric.unit)));
  cells.push_back(interval_cell(row, metric.unit));
  for (const double value : {row.median, row.min, row.max}) {
    cells.push_back(number_cell(displayed(value, metric.unit)));
  }
  return cells;
}

constexpr std::size_t kLongestOpenTable = 40;  // rows; what follows should not lie a mile below

std::string summary_html(const Results& results) {
  if (results.summary.empty()) return "";
  HtmlTable table;
  for (const SweepAxis& axis : results.axes) table.head.push_back(words_of(axis.path));
  for (const char* name : {"variant", "metric", "unit", "runs", "failed", "missing", "mean",
                           "95 % interval", "median", "min", "max"}) {
    table.head.push_back(name);
  }
  for (const SummaryRow& row : results.summary) {
    table.rows.push_back(summary_cells(results, row));
  }
  const std::string html =
      "<p class=\"note\">Over all runs of a level that have a value; the interval of the mean is "
      "by "
      "bootstrap. Failed runs are counted, not left out.</p>\n" +
      html_of(table);
  if (table.rows.size() <= kLongestOpenTable) return html;
  return folded(fmt::format("All {} rows", table.rows.size()), html);
}

std::string failures_html(const Results& results) {
  HtmlTable table{{"run", "seed", "level", "variant", "why it failed"}, {}};
  const auto whole = [](auto number) {
    const std::string text = fmt::to_string(number);
    return HtmlCell{text, text, true};
  };
  for (const RunRow& run : results.runs) {
    if (run.failure.empty()) continue;
    table.rows.push_back({whole(run.run), whole(run.seed), whole(run.level),
                          text_cell(results.variants[static_cast<std::size_t>(run.variant)]),
                          text_cell(run.failure)});
  }
  return table.rows.empty() ? "" : html_of(table);
}

std::string cost_html(const Results& results) {
  if (results.costs.empty()) return "";
  double seconds = 0.0, recording = 0.0, method = 0.0, recorded = 0.0, memory = 0.0;
  for (const CostRow& cost : results.costs) {
    seconds += cost.seconds;
    recording += cost.recording_seconds;
    method += cost.method_seconds;
    recorded += cost.recorded_seconds;
    memory = std::max(memory, cost.peak_memory);
  }
  std::string text = fmt::format(
      "<p>{} runs took {} s of processor time and {} s for their recordings; at most {} MB of "
      "memory were in use.",
      results.costs.size(), number_text(seconds), number_text(recording),
      number_text(memory / 1e6));
  if (seconds > 0.0 && recorded > 0.0) {
    text += fmt::format(" The logs last {} s: {} times as long as the runs took.",
                        number_text(recorded), number_text(recorded / seconds));
  }
  if (method > 0.0) {
    text += fmt::format(" The methods themselves took {} s: {} times real time.",
                        number_text(method), number_text(recorded / method));
  }
  return text + "</p>\n";
}

std::string origin_html(const Results& results) {
  std::string html = cost_html(results);
  if (!results.config_yaml.empty()) {
    html += folded("Configuration", preformatted(results.config_yaml));
  }
  if (!results.provenance_json.empty()) {
    html += folded("Provenance", preformatted(results.provenance_json));
  }
  return html;
}

}  // namespace

ClaimCount claims_of(const Results& results) {
  ClaimCount count;
  for (const Verdict& verdict : results.verdicts) {
    ++(!verdict.judged || results.quick ? count.not_judged
       : verdict.held                   ? count.held
                                        : count.not_held);
  }
  return count;
}

int failed_runs(const Results& results) {
  return static_cast<int>(std::count_if(results.runs.begin(), results.runs.end(),
                                        [](const RunRow& run) { return !run.failure.empty(); }));
}

bool stands_beside_thesis(const Results& results) {
  return std::any_of(results.verdicts.begin(), results.verdicts.end(),
                     [](const Verdict& verdict) { return !verdict.thesis.empty(); });
}

std::string claims_html(const Results& results) {
  if (results.verdicts.empty()) return "";
  const bool has_thesis = stands_beside_thesis(results);
  std::string html = fmt::format(
      "<table class=\"claims\">\n<thead><tr><th>Claim</th><th>Verdict</th>"
      "<th>Measured</th>{}</tr></thead>\n<tbody>\n",
      has_thesis ? "<th>Thesis</th>" : "");
  for (const Verdict& v : results.verdicts) {
    const bool is_verdict = v.judged && !results.quick;
    const std::string verdict = fmt::format("<span class=\"{}\">{}{}</span>",
                                            !is_verdict ? "not-judged"
                                            : v.held    ? "held"
                                                        : "not-held",
                                            !is_verdict ? ""
                                            : v.held    ? "\u2713 "
                                                        : "\u2717 ",
                                            text_of(v, results.quick));
    const std::string thesis =
        has_thesis ? "<td data-name=\"Thesis\">" + xml_escaped(v.thesis) + "</td>" : "";
    html += fmt::format("<tr><td>{}</td><td>{}</td><td data-name=\"Measured\">{}</td>{}</tr>\n",
                        xml_escaped(v.claim), verdict, xml_escaped(v.measured), thesis);
  }
  return "<div class=\"wide\">" + html + "</tbody>\n</table></div>\n";
}

std::string badges_html(const Results& results) {
  const ClaimCount claims = claims_of(results);
  std::string html = "<ul class=\"badges\">\n";
  const auto badge = [&](const std::string& text) { html += "<li>" + text + "</li>\n"; };
  const int judged = claims.held + claims.not_held;
  if (judged > 0) {
    badge(fmt::format("<span class=\"{}\">{} of {} claims held</span>",
                      claims.not_held == 0 ? "held" : "not-held", claims.held, judged));
  }
  if (claims.not_judged > 0 && !results.quick)
    badge(fmt::format("{} not judged", claims.not_judged));
  if (!results.runs.empty()) {
    badge(fmt::format("{} of {} runs failed", failed_runs(results), results.runs.size()));
  }
  if (results.quick) badge("quick run: a reduced version, no verdict on the claims");
  return html + "</ul>\n";
}

std::string scenario_page(const ReportedResults& reported) {
  const Results& results = reported.results;
  const std::string replays = replays_html(reported);
  HtmlPage page{.title = results.id + " \u2013 mapbed", .with_replay = !replays.empty()};
  const std::string question = results.about.empty() ? results.id : results.about;
  page.body = fmt::format("<header>\n<p class=\"kind\">Scenario <code>{}</code></p>\n<h1>{}</h1>\n",
                          xml_escaped(results.id), xml_escaped(question));
  if (!results.thesis.empty()) {
    page.body += "<p>Stands beside the thesis: " + xml_escaped(results.thesis) + "</p>\n";
  }
  page.body += badges_html(results) + skipped_html(results) + "</header>\n<main>\n";
  page.body += section("Claims", claims_html(results));
  page.body += section("Figures", figures_html(reported));
  page.body += section("Maps", maps_html(reported));
  page.body += section("Replay", replays);
  page.body += section("Numbers", summary_html(results));
  page.body += section("Failed runs", failures_html(results));
  page.body += section("How it was made", origin_html(results));
  page.body += "</main>\n";
  return html_of(page);
}

}  // namespace mapbed
