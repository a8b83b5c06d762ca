#include "bench/pages/overview_page.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "bench/pages/html.h"
#include "bench/pages/scenario_page.h"
#include "bench/plot/svg_text.h"
#include "core/file/atomic_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

std::string question_of(const ResultFolder& result) {
  return result.about.empty() ? result.id : result.about;
}

// The folder's own name, for links from its parent.
std::string place_of(const ResultFolder& result) {
  return fs::absolute(result.folder + "/.").lexically_normal().parent_path().filename().string();
}

std::string share(int part, int whole) {
  return whole == 0 ? "\u2013" : fmt::format("{} of {}", part, whole);
}

std::string held_text(const ResultFolder& result) {
  const ClaimCount claims = claims_of(result);
  return share(claims.held, claims.held + claims.not_held);
}

std::string failed_text(const ResultFolder& result) {
  const RunCount runs = runs_of(result);
  return share(runs.failed, runs.runs);
}

std::string table_html(const std::vector<ResultFolder>& results) {
  HtmlTable table{{"scenario", "question", "thesis", "claims held", "runs failed"}, {}};
  for (const ResultFolder& result : results) {
    const ClaimCount claims = claims_of(result);
    const std::string name = xml_escaped(place_of(result));
    table.rows.push_back(
        {{fmt::format("<a href=\"{0}/report.html\"><code>{0}</code></a>", name)},
         text_cell(question_of(result) + (result.quick ? " (quick run)" : "")),
         text_cell(result.thesis),
         {fmt::format("<span class=\"{}\">{}</span>", claims.not_held == 0 ? "held" : "not-held",
                      held_text(result))},
         text_cell(failed_text(result))});
  }
  return html_of(table);
}

std::string short_html(const ResultFolder& result) {
  const std::string name = xml_escaped(place_of(result));
  std::string html = fmt::format(
      "<section>\n<h2 id=\"{0}\">{1}</h2>\n<p class=\"note\"><a href=\"{0}/report.html\"><code>{2}"
      "</code></a>{3}</p>\n",
      name, xml_escaped(question_of(result)), xml_escaped(result.id),
      result.thesis.empty() ? "" : ", beside the thesis: " + xml_escaped(result.thesis));
  html += badges_html(result) + claims_html(result);
  if (!result.figures.empty()) {
    html += "<div class=\"figures\">\n";
    for (const NamedFile& figure : result.figures) {
      html += "<figure>\n" + figure.content + "</figure>\n";
    }
    html += "</div>\n";
  }
  return html + "</section>\n";
}

// Text in a cell of a Markdown table, or elsewhere in a line.
std::string markdown(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (std::string_view("\\`*_[]<>|#").find(c) != std::string_view::npos) result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result;
}

std::string short_markdown(const ResultFolder& result) {
  const std::string name = place_of(result);
  std::string text =
      fmt::format("\n## {}\n\n{}\n", markdown(result.id), markdown(question_of(result)));
  if (result.claims.size() > 1) {
    text += "\n| claim | verdict | measured | thesis |\n| --- | --- | --- | --- |\n";
  }
  for (std::size_t row = 1; row < result.claims.size(); ++row) {
    const std::string held = field(result.claims, row, "held");
    const char* verdict = held == "yes" ? "held" : held == "no" ? "**not held**" : "not judged";
    text += fmt::format("| {} | {} | {} | {} |\n", markdown(field(result.claims, row, "claim")),
                        verdict, markdown(field(result.claims, row, "measured")),
                        markdown(field(result.claims, row, "thesis")));
  }
  for (const NamedFile& figure : result.figures) {
    text += fmt::format("\n![{}]({}/figures/{})\n", markdown(figure.name), name, figure.name);
  }
  return text;
}

}  // namespace

std::string overview_page(const std::vector<ResultFolder>& results) {
  HtmlPage page{.title = "Results \u2013 mapbed"};
  int held = 0, judged = 0;
  for (const ResultFolder& result : results) {
    const ClaimCount claims = claims_of(result);
    held += claims.held;
    judged += claims.held + claims.not_held;
  }
  page.body = fmt::format(
      "<header>\n<p class=\"kind\">mapbed</p>\n<h1>Results</h1>\n<p>{} of {} claims held. Those "
      "that "
      "did not are shown like those that did.</p>\n</header>\n<main>\n",
      held, judged);
  page.body += table_html(results);
  for (const ResultFolder& result : results) page.body += short_html(result);
  page.body += "</main>\n";
  return html_of(page);
}

std::string overview_markdown(const std::vector<ResultFolder>& results) {
  std::string text =
      "# Results\n\nWritten by `mapbed report`. Each folder holds the complete configuration, the "
      "tables, the figures and what they were made with.\n\n"
      "| scenario | question | thesis | claims held | runs failed |\n"
      "| --- | --- | --- | --- | --- |\n";
  for (const ResultFolder& result : results) {
    text +=
        fmt::format("| [{}]({}/) | {}{} | {} | {} | {} |\n", markdown(result.id), place_of(result),
                    markdown(question_of(result)), result.quick ? " (quick run)" : "",
                    markdown(result.thesis), held_text(result), failed_text(result));
  }
  for (const ResultFolder& result : results) text += short_markdown(result);
  return text;
}

std::vector<std::string> write_reports(const std::string& folder) {
  std::vector<std::string> written;
  const auto write = [&](const std::string& path, const std::string& text) {
    write_file(path, text);
    written.push_back(path);
  };
  std::vector<ResultFolder> results;
  for (const std::string& path : result_folders(folder)) {
    results.push_back(load_result_folder(path));
    write((fs::path(path) / "report.html").string(), scenario_page(results.back()));
  }
  if (is_result_folder(folder)) return written;
  write((fs::path(folder) / "report.html").string(), overview_page(results));
  write((fs::path(folder) / "README.md").string(), overview_markdown(results));
  return written;
}

}  // namespace mapbed
