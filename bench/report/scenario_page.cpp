#include "bench/report/scenario_page.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/report/axis.h"
#include "bench/report/html.h"
#include "bench/report/svg_text.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

std::string section(const std::string& title, const std::string& html) {
  return html.empty() ? "" : "<section>\n<h2>" + title + "</h2>\n" + html + "</section>\n";
}

std::string without_extension(const std::string& name) {
  return name.substr(0, name.rfind('.'));
}

std::string figures_html(const ResultFolder& result) {
  std::string html;
  for (const NamedFile& figure : result.figures) {
    const std::string base = "figures/" + without_extension(figure.name);
    html += fmt::format(
        "<figure>\n{0}<figcaption>Files: <a href=\"{1}.svg\">picture</a>, "
        "<a href=\"{1}.csv\">numbers</a></figcaption></figure>\n",
        figure.content, xml_escaped(base));
  }
  return html.empty() ? "" : "<div class=\"figures\">\n" + html + "</div>\n";
}

std::string maps_html(const ResultFolder& result) {
  std::string html;
  for (const NamedFile& map : result.maps) {
    const std::string name = xml_escaped(without_extension(map.name));
    html += fmt::format(
        "<figure><img src=\"{}\" alt=\"Map: {}\" loading=\"lazy\"><figcaption>{}"
        "</figcaption></figure>\n",
        png_address(map.content), name, name);
  }
  return html.empty() ? "" : "<div class=\"figures\">\n" + html + "</div>\n";
}

constexpr const char* kPlayer = R"(<div class="replay">
<canvas role="img" aria-label="The run at the chosen moment"></canvas>
<div class="controls"><button type="button">Play</button>
<input type="range" aria-label="Time">
<label>Speed <select><option value="1">1 x</option><option value="5" selected>5 x</option>
<option value="20">20 x</option></select></label></div>
<output></output>
<div class="controls">)";

std::string check_box(const char* name, const char* text, const char* color) {
  return fmt::format(
      "<label><input type=\"checkbox\" name=\"{}\" checked> <span class=\"key\" "
      "style=\"border-color:{}\"></span>{}</label>\n",
      name, color, text);
}

// JSON within a script element must not end it: "<" only stands in texts there, and may be
// written as an escape.
std::string in_script(const std::string& json) {
  std::string result;
  for (const char c : json) result += c == '<' ? "\\u003c" : std::string(1, c);
  return result;
}

std::string replays_html(const ResultFolder& result) {
  std::string html;
  for (const NamedFile& file : result.replays) {
    const auto json = nlohmann::json::parse(file.content, nullptr, false);
    if (!json.is_object()) {
      throw InputError({result.folder + "/replays/" + file.name},
                       "is no replay: not a JSON object");
    }
    const std::string title = json.value("title", "");
    std::string name = without_extension(file.name);  // says level and variant
    std::replace(name.begin(), name.end(), '_', ' ');
    html += "<h3>" + xml_escaped(title.empty() ? name : title + ": " + name) + "</h3>\n";
    html += kPlayer;
    if (json.contains("truth")) html += check_box("truth", "true path", "#009e73");
    if (json.contains("estimate")) html += check_box("estimate", "estimate", "#0072b2");
    if (json.contains("odometry")) html += check_box("odometry", "odometry", "#e69f00");
    if (json.contains("scans")) html += check_box("scan", "scan", "#d55e00");
    if (json.contains("others")) html += check_box("people", "people and doors", "#cc79a7");
    if (json.contains("map")) html += check_box("map", "map", "#777777");
    html += "</div>\n<script type=\"application/json\">" + in_script(file.content) +
            "</script>\n</div>\n";
  }
  return html;
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
  return "<p class=\"note\">Over all runs of a level that have a value; the interval of the mean "
         "is "
         "by bootstrap. Failed runs are counted, not left out.</p>\n" +
         html_of(table);
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
