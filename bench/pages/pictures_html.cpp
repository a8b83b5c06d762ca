#include "bench/pages/pictures_html.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/pages/figure_html.h"
#include "bench/plot/svg_text.h"
#include "bench/results/run_files.h"
#include "core/file/text_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestPicture = std::size_t{1} << 25;  // [bytes]

std::string without_extension(const std::string& name) {
  return name.substr(0, name.rfind('.'));
}

// As it was drawn now; else nothing.
const ResultFile* drawn(const ReportedResults& reported, const std::string& path) {
  const auto found = std::find_if(reported.drawn.begin(), reported.drawn.end(),
                                  [&](const ResultFile& file) { return file.path == path; });
  return found == reported.drawn.end() ? nullptr : &*found;
}

bool is_there(const ReportedResults& reported, const std::string& path) {
  return drawn(reported, path) != nullptr || fs::exists(fs::path(reported.folder) / path);
}

// "map, people 3, raw"
std::string joined(const std::string& title, const std::string& run) {
  return title + (title.empty() || run.empty() ? "" : ", ") + run;
}

// Of single runs, in that folder. Results are kept without their larger files, too.
std::vector<Picture> pictures_of_runs(const ReportedResults& reported, const std::string& inner,
                                      const std::string& extension) {
  const Results& results = reported.results;
  std::vector<Picture> pictures;
  for (const FileOfRun& file : results.files) {
    const bool is_one = file.path.starts_with(inner + "/") && file.path.ends_with(extension);
    if (!is_one || !is_there(reported, file.path)) continue;
    const auto run = std::find_if(results.runs.begin(), results.runs.end(),
                                  [&](const RunRow& row) { return row.run == file.run; });
    pictures.push_back(
        {file.path, file.title, run == results.runs.end() ? "" : run_words(results, *run)});
  }
  std::sort(pictures.begin(), pictures.end(),
            [](const Picture& a, const Picture& b) { return in_natural_order(a.path, b.path); });
  return pictures;
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

std::string caption_of(const Picture& picture) {
  return joined(picture.title, picture.run);
}

std::vector<Picture> figures_of(const ReportedResults& reported) {
  std::vector<Picture> figures;
  for (const PlotSpec& plot : reported.results.plots) {
    const std::string path = "figures/" + plot.file + ".svg";
    if (is_there(reported, path)) figures.push_back({path, plot.title, ""});
  }
  const std::vector<Picture> of_runs = pictures_of_runs(reported, "figures", ".svg");
  figures.insert(figures.end(), of_runs.begin(), of_runs.end());
  return figures;
}

std::string content_of(const ReportedResults& reported, const Picture& picture) {
  if (const ResultFile* file = drawn(reported, picture.path)) return file->content;
  return read_text_file((fs::path(reported.folder) / picture.path).string(), kLargestPicture);
}

std::string figures_html(const ReportedResults& reported) {
  std::string html;
  for (const Picture& figure : figures_of(reported)) {
    html += fmt::format(
        "<figure>\n{0}<figcaption>Files: <a href=\"{1}.svg\">picture</a>, "
        "<a href=\"{1}.csv\">numbers</a></figcaption></figure>\n",
        figure_html(content_of(reported, figure)), xml_escaped(without_extension(figure.path)));
  }
  return html.empty() ? "" : "<div class=\"figures\">\n" + html + "</div>\n";
}

std::string maps_html(const ReportedResults& reported) {
  std::string html;
  for (const Picture& map : pictures_of_runs(reported, "maps", ".png")) {
    const std::string title = xml_escaped(caption_of(map));
    html += fmt::format(
        "<figure><img src=\"{}\" alt=\"Map: {}\" loading=\"lazy\"><figcaption>{}"
        "</figcaption></figure>\n",
        png_address(content_of(reported, map)), title, title);
  }
  return html.empty() ? "" : "<div class=\"figures\">\n" + html + "</div>\n";
}

std::string replays_html(const ReportedResults& reported) {
  std::string html;
  for (const Picture& replay : pictures_of_runs(reported, "replays", ".json")) {
    const std::string content = content_of(reported, replay);
    const auto json = nlohmann::json::parse(content, nullptr, false);
    if (!json.is_object()) {
      throw InputError({(fs::path(reported.folder) / replay.path).string()},
                       "is not a replay: not a JSON object");
    }
    const auto named = json.find("title");
    const std::string title =
        named != json.end() && named->is_string() ? named->get<std::string>() : "";
    html +=
        "<h3>" + xml_escaped(joined(title.empty() ? replay.title : title, replay.run)) + "</h3>\n";
    html += kPlayer;
    if (json.contains("truth")) html += check_box("truth", "true path", "#009e73");
    if (json.contains("estimate")) html += check_box("estimate", "estimate", "#0072b2");
    if (json.contains("odometry")) html += check_box("odometry", "odometry", "#e69f00");
    if (json.contains("scans")) html += check_box("scan", "scan", "#d55e00");
    if (json.contains("others")) html += check_box("people", "people and doors", "#cc79a7");
    if (json.contains("map")) html += check_box("map", "map", "#777777");
    html +=
        "</div>\n<script type=\"application/json\">" + in_script(content) + "</script>\n</div>\n";
  }
  return html;
}

}  // namespace mapbed
