#include "bench/pages/pictures_html.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/pages/html.h"
#include "bench/plot/svg_text.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

std::string without_extension(const std::string& name) {
  return name.substr(0, name.rfind('.'));
}

// The values of the axes at a level, which the table of runs names: "rotation sigma 4 deg".
std::string level_words(const ResultFolder& result, const std::string& level) {
  for (std::size_t row = 1; row < result.runs.size(); ++row) {
    if (field(result.runs, row, "level") != level) continue;
    std::string words;
    const CsvRow& head = result.runs.front();
    const auto first = std::find(head.begin(), head.end(), "level");
    for (auto axis = first + 1; axis != head.end() && *axis != "variant"; ++axis) {
      words += (words.empty() ? "" : ", ") + axis->substr(axis->rfind('.') + 1) + " " +
               field(result.runs, row, *axis);
    }
    return words;
  }
  return "level " + level;
}

// "map_level_2_raw.png" in words: "map, rotation sigma 4 deg, raw".
std::string words_of(const std::string& file, const ResultFolder& result) {
  std::string name = without_extension(file);
  const std::string mark = "_level_";
  const std::size_t at = name.find(mark);
  if (at != std::string::npos) {
    const std::size_t digits = at + mark.size();
    const std::size_t end = std::min(name.find('_', digits), name.size());
    const std::string level = level_words(result, name.substr(digits, end - digits));
    name = name.substr(0, at) + ", " + level + (end < name.size() ? ", " : "") +
           name.substr(std::min(end + 1, name.size()));
  }
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
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

}  // namespace

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
    const std::string name = xml_escaped(words_of(map.name, result));
    html += fmt::format(
        "<figure><img src=\"{}\" alt=\"Map: {}\" loading=\"lazy\"><figcaption>{}"
        "</figcaption></figure>\n",
        png_address(map.content), name, name);
  }
  return html.empty() ? "" : "<div class=\"figures\">\n" + html + "</div>\n";
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
    const std::string name = words_of(file.name, result);  // says level and variant
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

}  // namespace mapbed
