#include "bench/pages/pictures_html.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <unordered_map>
#include <utility>

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
using Json = nlohmann::ordered_json;

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

constexpr const char* kPlayer =
    R"(<canvas tabindex="0" role="img" aria-label="The run at the chosen moment"></canvas>
<div class="controls"><button type="button">Play</button>
<input type="range" aria-label="Time">
<label>Speed <select name="speed"><option value="1">1 x</option><option value="5" selected>5 x</option>
<option value="20">20 x</option></select></label></div>
<output></output>
<div class="controls">)";

struct Layer {
  const char* name;  // in a replay's JSON
  const char* text;
  const char* color;
};
constexpr std::array<Layer, 8> kLayers = {{{"truth", "true path", "#009e73"},
                                           {"estimate", "estimate", "#0072b2"},
                                           {"odometry", "odometry", "#e69f00"},
                                           {"scans", "scan", "#d55e00"},
                                           {"labels", "called dynamic", "#e67800"},
                                           {"others", "people and doors", "#cc79a7"},
                                           {"tracks", "people followed; dashed: hidden", "#882255"},
                                           {"map", "map", "#777777"}}};
constexpr const char* kScanBesideLabels = "#555555";

bool any_has(const Json& runs, const char* layer) {
  return std::any_of(runs.begin(), runs.end(),
                     [&](const Json& run) { return run.contains(layer); });
}

// Every layer that one of the runs has.
std::string check_boxes(const Json& runs) {
  std::string html;
  for (const Layer& layer : kLayers) {
    if (!any_has(runs, layer.name)) continue;
    const bool is_beside = std::string_view(layer.name) == "scans" && any_has(runs, "labels");
    html += fmt::format(
        "<label><input type=\"checkbox\" name=\"{}\" checked> <span class=\"key\" "
        "style=\"border-color:{}\"></span>{}</label>\n",
        layer.name, is_beside ? kScanBesideLabels : layer.color, layer.text);
  }
  return html;
}

std::string run_choice(const Json& runs) {
  std::string html = "<label class=\"run\">Run <select name=\"run\">\n";
  for (std::size_t i = 0; i < runs.size(); ++i) {
    html += fmt::format("<option value=\"{}\">{}</option>\n", i,
                        xml_escaped(runs[i].at("title").get<std::string>()));
  }
  return html + "</select></label>\n";
}

constexpr const char* kKeys =
    "<p class=\"note\">Keys on the picture: space plays and pauses, \u2190 and \u2192 go by a "
    "second{}.</p>\n";

Json replay_of(const ReportedResults& reported, const Picture& picture) {
  Json replay = Json::parse(content_of(reported, picture), nullptr, false);
  if (!replay.is_object()) {
    throw InputError({(fs::path(reported.folder) / picture.path).string()},
                     "is not a replay: not a JSON object");
  }
  const auto named = replay.find("title");
  const std::string title =
      named != replay.end() && named->is_string() ? named->get<std::string>() : "";
  replay["title"] = joined(title.empty() ? picture.title : title, picture.run);
  return replay;
}

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// What runs have in common, such as outlines and people, stands once: lists and objects move to
// `parts`, and the run has their number.
class SharedParts {
 public:
  void take_from(Json& replay) {
    for (Json& value : replay) {
      if (!value.is_structured()) continue;
      const auto [known, is_new] = numbers_.emplace(text_of(value), numbers_.size());
      if (is_new) texts_.push_back(&known->first);
      value = known->second;
    }
  }
  // As JSON.
  std::string text() const {
    std::string text;
    for (const std::string* part : texts_) text += (text.empty() ? "" : ",\n") + *part;
    return "[" + text + "]";
  }

 private:
  std::unordered_map<std::string, std::size_t> numbers_;
  std::vector<const std::string*> texts_;  // keys of numbers_, which stay where they are
};

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
  Json runs = Json::array();
  SharedParts parts;
  for (const Picture& picture : pictures_of_runs(reported, "replays", ".json")) {
    Json replay = replay_of(reported, picture);
    parts.take_from(replay);
    runs.push_back(std::move(replay));
  }
  if (runs.empty()) return "";
  const bool several = runs.size() > 1;
  const std::string data = "{\"parts\": " + parts.text() + ",\n\"runs\": " + text_of(runs) + "}";
  return "<div class=\"replay\">\n" +
         (several ? run_choice(runs)
                  : "<h3>" + xml_escaped(runs[0].at("title").get<std::string>()) + "</h3>\n") +
         kPlayer + check_boxes(runs) + "</div>\n" +
         fmt::format(kKeys, several ? ", \u2191 and \u2193 choose the run" : "") +
         "<script type=\"application/json\">" + in_script(data) + "</script>\n</div>\n";
}

}  // namespace mapbed
