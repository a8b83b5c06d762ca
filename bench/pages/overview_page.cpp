#include "bench/pages/overview_page.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "bench/pages/figure_html.h"
#include "bench/pages/html.h"
#include "bench/pages/paper_table.h"
#include "bench/pages/pictures_html.h"
#include "bench/pages/scenario_page.h"
#include "bench/plot/svg_text.h"
#include "core/file/file_reader.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

std::string question_of(const Results& results) {
  return results.about.empty() ? results.id : results.about;
}

// The folder's own name, for links from its parent.
std::string place_of(const ReportedResults& result) {
  return fs::absolute(result.folder + "/.").lexically_normal().parent_path().filename().string();
}

std::string fraction(int part, int whole) {
  return whole == 0 ? "\u2013" : fmt::format("{} of {}", part, whole);
}

std::string held_text(const Results& results) {
  const ClaimCount claims = claims_of(results);
  return fraction(claims.held, claims.held + claims.not_held);
}

std::string failed_text(const Results& results) {
  return fraction(failed_runs(results), static_cast<int>(results.runs.size()));
}

std::string table_html(const std::vector<ReportedResults>& all) {
  HtmlTable table{{"scenario", "question", "thesis", "claims held", "runs failed"}, {}};
  for (const ReportedResults& result : all) {
    const ClaimCount claims = claims_of(result.results);
    const std::string name = xml_escaped(place_of(result));
    table.rows.push_back(
        {{fmt::format("<a href=\"{0}/report.html\"><code>{0}</code></a>", name)},
         text_cell(question_of(result.results) + (result.results.quick ? " (quick run)" : "")),
         text_cell(result.results.thesis),
         {fmt::format("<span class=\"{}\">{}</span>", claims.not_held == 0 ? "held" : "not-held",
                      held_text(result.results))},
         text_cell(failed_text(result.results))});
  }
  return html_of(table);
}

std::string short_html(const ReportedResults& result) {
  const std::string name = xml_escaped(place_of(result));
  std::string html = fmt::format(
      "<section>\n<h2 id=\"{0}\">{1}</h2>\n<p class=\"note\"><a href=\"{0}/report.html\"><code>{2}"
      "</code></a>{3}</p>\n",
      name, xml_escaped(question_of(result.results)), xml_escaped(result.results.id),
      result.results.thesis.empty() ? ""
                                    : ", beside the thesis: " + xml_escaped(result.results.thesis));
  html += badges_html(result.results) + claims_html(result.results);
  const std::vector<Picture> figures = figures_of(result);
  if (!figures.empty()) html += "<div class=\"figures\">\n";
  for (const Picture& figure : figures) {
    html += "<figure>\n" + figure_html(content_of(result, figure)) + "</figure>\n";
  }
  if (!figures.empty()) html += "</div>\n";
  return html + "</section>\n";
}

std::string short_markdown(const ReportedResults& result) {
  const std::string name = place_of(result);
  std::string text = fmt::format("\n## {}\n\n{}\n", markdown_escaped(result.results.id),
                                 markdown_escaped(question_of(result.results)));
  const bool has_thesis = stands_beside_thesis(result.results);
  if (!result.results.verdicts.empty()) {
    text += fmt::format("\n| claim | verdict | measured |{}\n| --- | --- | --- |{}\n",
                        has_thesis ? " thesis |" : "", has_thesis ? " --- |" : "");
  }
  for (const Verdict& v : result.results.verdicts) {
    std::string verdict = text_of(v, result.results.quick);
    if (verdict == "not held") verdict = "**not held**";
    text += fmt::format("| {} | {} | {} |", markdown_escaped(v.claim), verdict,
                        markdown_escaped(v.measured));
    text += has_thesis ? " " + markdown_escaped(v.thesis) + " |\n" : "\n";
  }
  for (const Picture& figure : figures_of(result)) {
    text +=
        fmt::format("\n![{}]({}/{})\n", markdown_escaped(caption_of(figure)), name, figure.path);
  }
  return text;
}

constexpr std::string_view kMarkdownMark = "\n\nWritten by `mapbed report`.";

}  // namespace

std::string overview_page(const std::vector<ReportedResults>& all) {
  HtmlPage page{.title = "Results \u2013 mapbed"};
  int held = 0, judged = 0;
  for (const ReportedResults& result : all) {
    const ClaimCount claims = claims_of(result.results);
    held += claims.held;
    judged += claims.held + claims.not_held;
  }
  page.body = fmt::format(
      "<header>\n<p class=\"kind\">mapbed</p>\n<h1>Results</h1>\n<p>{} of {} claims held. Those "
      "that "
      "did not are shown like those that did.</p>\n</header>\n<main>\n",
      held, judged);
  page.body += table_html(all);
  for (const ReportedResults& result : all) page.body += short_html(result);
  page.body += "</main>\n";
  return html_of(page);
}

std::string overview_markdown(const std::vector<ReportedResults>& all) {
  const bool has_thesis = std::any_of(all.begin(), all.end(), [](const ReportedResults& result) {
    return !result.results.thesis.empty();
  });
  std::string text =
      "# Results" + std::string(kMarkdownMark) +
      " Each folder holds the complete configuration, the tables, the figures and what they were "
      "made with.\n\n";
  text += fmt::format(
      "| scenario | question |{} claims held | runs failed |\n| --- | --- |{} --- | --- |\n",
      has_thesis ? " thesis |" : "", has_thesis ? " --- |" : "");
  for (const ReportedResults& result : all) {
    text += fmt::format("| [{}]({}/) | {}{} |", markdown_escaped(result.results.id),
                        place_of(result), markdown_escaped(question_of(result.results)),
                        result.results.quick ? " (quick run)" : "");
    if (has_thesis) text += " " + markdown_escaped(result.results.thesis) + " |";
    text += " " + held_text(result.results) + " | " + failed_text(result.results) + " |\n";
  }
  for (const ReportedResults& result : all) text += short_markdown(result);
  return text;
}

bool is_markdown_of_ours(const std::string& path) {
  FileReader file(path);
  return file.next().find(kMarkdownMark) != std::string_view::npos;
}

}  // namespace mapbed
