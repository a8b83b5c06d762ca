#include "bench/pages/scenario_page.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "bench/pages/html.h"
#include "bench/pages/pictures_html.h"
#include "bench/plot/axis.h"
#include "bench/plot/svg_text.h"

namespace mapbed {
namespace {

std::string section(const std::string& title, const std::string& html) {
  return html.empty() ? "" : "<section>\n<h2>" + title + "</h2>\n" + html + "</section>\n";
}

std::string skipped_html(const ResultFolder& result) {
  std::string html;
  for (const std::string& line : result.skipped) {
    html += "<p class=\"note\">Left out: " + xml_escaped(line) + ".</p>\n";
  }
  return html;
}

double shown(double value, const std::string& unit) {
  return unit.starts_with("rad") ? value * 180.0 / std::numbers::pi : value;
}

std::string shown_unit(const std::string& unit) {
  return unit.starts_with("rad") ? "deg" + unit.substr(3) : unit;
}

bool one_of(const std::string& name, std::initializer_list<const char*> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// A column of summary.csv as people read it: the interval in one cell, angles in degrees.
HtmlCell summary_cell(const CsvTable& table, std::size_t row, const std::string& column) {
  const std::string text = field(table, row, column);
  const std::string unit = field(table, row, "unit");
  if (column == "unit") return text_cell(shown_unit(text));
  if (one_of(column, {"runs", "failed", "missing"})) {
    return number_cell(parse_csv_number(text), 9);
  }
  const double value = shown(parse_csv_number(text), unit);
  if (column == "low") {
    const double high = shown(parse_csv_number(field(table, row, "high")), unit);
    if (std::isnan(value) || std::isnan(high)) return {"\u2013", "", true};
    return {number_text(value, 4) + " to " + number_text(high, 4), csv_number(value), true};
  }
  if (one_of(column, {"mean", "median", "min", "max"})) return number_cell(value);
  std::string words = text;
  if (column == "metric") std::replace(words.begin(), words.end(), '_', ' ');
  return text_cell(words);
}

constexpr std::size_t kLongestOpenTable = 40;  // rows; what follows should not lie a mile below

std::string summary_html(const ResultFolder& result) {
  if (result.summary.size() < 2) return "";
  HtmlTable table;
  std::vector<std::string> columns;
  for (const std::string& column : result.summary.front()) {
    if (column == "high" || column == "level") continue;
    columns.push_back(column);
    std::string name = column.substr(column.rfind('.') + 1);  // of an axis, without its path
    std::replace(name.begin(), name.end(), '_', ' ');
    table.head.push_back(column == "low" ? "95 % interval" : name);
  }
  for (std::size_t row = 1; row < result.summary.size(); ++row) {
    std::vector<HtmlCell>& cells = table.rows.emplace_back();
    for (const std::string& column : columns) {
      cells.push_back(summary_cell(result.summary, row, column));
    }
  }
  const std::string html =
      "<p class=\"note\">Over all runs of a level that have a value; the interval of the mean is "
      "by "
      "bootstrap. Failed runs are counted, not left out.</p>\n" +
      html_of(table);
  if (table.rows.size() <= kLongestOpenTable) return html;
  return folded(fmt::format("All {} rows", table.rows.size()), html);
}

std::string failures_html(const ResultFolder& result) {
  HtmlTable table{{"run", "seed", "level", "variant", "why it failed"}, {}};
  for (std::size_t row = 1; row < result.runs.size(); ++row) {
    const std::string failure = field(result.runs, row, "failure");
    if (failure.empty()) continue;
    std::vector<HtmlCell>& cells = table.rows.emplace_back();
    for (const char* column : {"run", "seed", "level"}) {
      cells.push_back(
          {xml_escaped(field(result.runs, row, column)), field(result.runs, row, column), true});
    }
    cells.push_back(text_cell(field(result.runs, row, "variant")));
    cells.push_back(text_cell(failure));
  }
  return table.rows.empty() ? "" : html_of(table);
}

std::string cost_html(const ResultFolder& result) {
  if (result.cost.size() < 2) return "";
  double seconds = 0.0, recording = 0.0, method = 0.0, recorded = 0.0, memory = 0.0;
  const auto number = [&](std::size_t row, const char* column) {
    const double value = parse_csv_number(field(result.cost, row, column));
    return std::isnan(value) ? 0.0 : value;
  };
  for (std::size_t row = 1; row < result.cost.size(); ++row) {
    seconds += number(row, "seconds");
    recording += number(row, "recording_seconds");
    method += number(row, "method_seconds");
    recorded += number(row, "recorded_seconds");
    memory = std::max(memory, number(row, "peak_memory_bytes"));
  }
  std::string text = fmt::format(
      "<p>{} runs took {} s of processor time and {} s for their recordings; at most {} MB of "
      "memory were in use.",
      result.cost.size() - 1, number_text(seconds), number_text(recording),
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

std::string origin_html(const ResultFolder& result) {
  std::string html = cost_html(result);
  if (!result.config.empty()) html += folded("Configuration", preformatted(result.config));
  if (!result.provenance.empty()) html += folded("Provenance", preformatted(result.provenance));
  return html;
}

}  // namespace

std::string claims_html(const ResultFolder& result) {
  if (result.claims.size() < 2) return "";
  std::string html =
      "<table class=\"claims\">\n<thead><tr><th>Claim</th><th>Verdict</th>"
      "<th>Measured</th><th>Thesis</th></tr></thead>\n<tbody>\n";
  for (std::size_t row = 1; row < result.claims.size(); ++row) {
    const auto text = [&](const char* column) {
      return xml_escaped(field(result.claims, row, column));
    };
    const std::string held = field(result.claims, row, "held");
    const std::string verdict = held == "yes"  ? "<span class=\"held\">\u2713 held</span>"
                                : held == "no" ? "<span class=\"not-held\">\u2717 not held</span>"
                                               : "<span class=\"not-judged\">not judged</span>";
    html += fmt::format(
        "<tr><td>{}</td><td>{}</td><td data-name=\"Measured\">{}</td>"
        "<td data-name=\"Thesis\">{}</td></tr>\n",
        text("claim"), verdict, text("measured"), text("thesis"));
  }
  return "<div class=\"wide\">" + html + "</tbody>\n</table></div>\n";
}

std::string badges_html(const ResultFolder& result) {
  const ClaimCount claims = claims_of(result);
  const RunCount runs = runs_of(result);
  std::string html = "<ul class=\"badges\">\n";
  const auto badge = [&](const std::string& text) { html += "<li>" + text + "</li>\n"; };
  const int judged = claims.held + claims.not_held;
  if (judged > 0) {
    badge(fmt::format("<span class=\"{}\">{} of {} claims held</span>",
                      claims.not_held == 0 ? "held" : "not-held", claims.held, judged));
  }
  if (claims.not_judged > 0) badge(fmt::format("{} not judged", claims.not_judged));
  if (runs.runs > 0) badge(fmt::format("{} of {} runs failed", runs.failed, runs.runs));
  if (result.quick) badge("quick run: a reduced version, not the result");
  return html + "</ul>\n";
}

std::string scenario_page(const ResultFolder& result) {
  HtmlPage page{.title = result.id + " \u2013 mapbed", .with_replay = !result.replays.empty()};
  const std::string question = result.about.empty() ? result.id : result.about;
  page.body = fmt::format("<header>\n<p class=\"kind\">Scenario <code>{}</code></p>\n<h1>{}</h1>\n",
                          xml_escaped(result.id), xml_escaped(question));
  if (!result.thesis.empty()) {
    page.body += "<p>Stands beside the thesis: " + xml_escaped(result.thesis) + "</p>\n";
  }
  page.body += badges_html(result) + skipped_html(result) + "</header>\n<main>\n";
  page.body += section("Claims", claims_html(result));
  page.body += section("Figures", figures_html(result));
  page.body += section("Maps", maps_html(result));
  page.body += section("Replay", replays_html(result));
  page.body += section("Numbers", summary_html(result));
  page.body += section("Failed runs", failures_html(result));
  page.body += section("How it was made", origin_html(result));
  page.body += "</main>\n";
  return html_of(page);
}

}  // namespace mapbed
