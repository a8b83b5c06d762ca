#include "bench/pages/html.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "bench/pages/page_files.h"
#include "bench/plot/axis.h"
#include "bench/plot/svg_text.h"
#include "core/check.h"
#include "core/file/csv_file.h"
#include "core/file/file_reader.h"

namespace mapbed {
namespace {

constexpr std::string_view kMark = "<meta name=\"generator\" content=\"mapbed\">\n";
constexpr std::string_view kMarkOfOlderPages = "<header>\n<p class=\"kind\">";

bool is_empty(const HtmlCell& cell) {
  return cell.is_number ? cell.sort_by.empty() : cell.html.empty();
}

// All of them where there are no rows.
std::vector<std::size_t> columns_with_values(const HtmlTable& table) {
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < table.head.size(); ++i) {
    const bool none = std::all_of(table.rows.begin(), table.rows.end(),
                                  [i](const auto& row) { return is_empty(row.at(i)); });
    if (table.rows.empty() || !none) columns.push_back(i);
  }
  return columns;
}

// With its column's name, which a narrow page shows before it.
std::string html_of(const HtmlCell& cell, const std::string& column) {
  constexpr std::size_t kShort = 24;  // [bytes] stays on one line; the table scrolls
  const char* style = cell.is_number               ? " class=\"number\""
                      : cell.html.size() <= kShort ? " class=\"short\""
                                                   : "";
  const std::string sort_by = cell.is_number ? fmt::format(" data-value=\"{}\"", cell.sort_by) : "";
  return fmt::format("<td data-name=\"{}\"{}{}>{}</td>", xml_escaped(column), style, sort_by,
                     cell.html);
}

}  // namespace

std::string html_of(const HtmlPage& page) {
  std::string text = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  text += kMark;
  text += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  text += "<link rel=\"icon\" href=\"data:,\">\n";  // else a browser looks for one
  text += "<title>" + xml_escaped(page.title) + "</title>\n<style>\n";
  text += page_style();
  text += "</style>\n</head>\n<body>\n" + page.body + "<script>\n";
  text += page_script();
  if (page.with_replay) text += replay_script();
  return text + "</script>\n</body>\n</html>\n";
}

bool is_page_of_ours(const std::string& path) {
  FileReader file(path);
  const std::string_view begin = file.next();
  return begin.find(kMark) != std::string_view::npos ||
         begin.find(kMarkOfOlderPages) != std::string_view::npos;
}

HtmlCell text_cell(const std::string& text) {
  return {xml_escaped(text)};
}

HtmlCell number_cell(double value, int digits) {
  if (std::isnan(value)) return {"\u2013", "", true};
  const std::string exact = csv_number(value);
  return {fmt::format("<span title=\"{}\">{}</span>", exact, number_text(value, digits)), exact,
          true};
}

std::string html_of(const HtmlTable& table) {
  const std::vector<std::size_t> columns = columns_with_values(table);
  std::string text = "<div class=\"wide\"><table class=\"sortable\">\n<thead><tr>";
  for (const std::size_t i : columns) {
    const bool number = !table.rows.empty() && table.rows.front()[i].is_number;
    text += fmt::format("<th{}><button type=\"button\">{}</button></th>",
                        number ? " class=\"number\"" : "", xml_escaped(table.head[i]));
  }
  text += "</tr></thead>\n<tbody>\n";
  for (const std::vector<HtmlCell>& row : table.rows) {
    CHECK(row.size() == table.head.size());
    text += "<tr>";
    for (const std::size_t i : columns) text += html_of(row[i], table.head[i]);
    text += "</tr>\n";
  }
  return text + "</tbody>\n</table></div>\n";
}

std::string folded(const std::string& summary, const std::string& html) {
  return fmt::format("<details>\n<summary>{}</summary>\n{}</details>\n", xml_escaped(summary),
                     html);
}

std::string preformatted(const std::string& text) {
  return "<pre>" + xml_escaped(text) + "</pre>\n";
}

}  // namespace mapbed
