#pragma once

#include <string>
#include <vector>

namespace mapbed {

// A whole page in one file: style and script inside, nothing is fetched.
struct HtmlPage {
  std::string title;
  std::string body;
  bool with_replay = false;  // the player of replay.h
};
std::string html_of(const HtmlPage& page);

// Whether html_of has made what stands in that file, now or in an earlier version.
bool is_page_of_ours(const std::string& path);

// A cell: HTML to be seen, and the value to sort by where that differs from the text.
struct HtmlCell {
  std::string html;
  std::string sort_by = {};
  bool is_number = false;
};
HtmlCell text_cell(const std::string& text);
HtmlCell number_cell(double value, int digits = 4);  // the exact value is its tool tip

struct HtmlTable {
  std::vector<std::string> head;
  std::vector<std::vector<HtmlCell>> rows;  // as many cells as the head
};
// Sorted by a click on a column's name; scrolls sideways within itself where the window is narrow.
// A column that has no value in any row is left out.
std::string html_of(const HtmlTable& table);

// "<details>": shown when asked for.
std::string folded(const std::string& summary, const std::string& html);
std::string preformatted(const std::string& text);

}  // namespace mapbed
