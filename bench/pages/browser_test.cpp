// Opens pages in a real browser, headless, as wide as a telephone and as a desktop: no console
// message, nothing wider than the window, and the controls work. Skipped where there is no
// Chromium.

#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "bench/pages/figure_html.h"
#include "bench/pages/html.h"
#include "bench/pages/reports.h"
#include "bench/pages/testing/example_results.h"
#include "bench/plot/heat_map.h"
#include "bench/plot/matrix.h"
#include "bench/plot/plot.h"
#include "bench/plot/svg_text.h"
#include "core/file/text_file.h"
#include "core/file/tokens.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

bool has_chromium() {
  return std::system("command -v chromium >/dev/null 2>&1") == 0;
}

// The page in a frame of the wanted width (a window cannot be as narrow as a telephone), used as a
// person would: every table sorted, every fold opened, the replay moved. What came of it stands in
// the attributes of #result.
std::string framed(const std::string& page, int width) {
  constexpr const char* kUse = R"(<p id="result"></p><script>
"use strict";
addEventListener("load", () => {
  const frame = document.querySelector("iframe"), page = frame.contentDocument;
  const result = document.querySelector("#result");
  for (const fold of page.querySelectorAll("details")) fold.open = true;
  for (const head of page.querySelectorAll("th button")) { head.click(); head.click(); }
  for (const slider of page.querySelectorAll("input[type=range]")) {
    slider.value = 5;
    slider.dispatchEvent(new frame.contentWindow.Event("input"));
    result.dataset.clock = page.querySelector("output").textContent;
    const c = page.querySelector("canvas");
    const pixels = c.getContext("2d").getImageData(0, 0, c.width, c.height).data;
    result.dataset.drawn = String(pixels.some((x) => x !== 0));
    const pixelsLike = (r, g, b) => {
      const copy = new OffscreenCanvas(c.width, c.height).getContext("2d", { willReadFrequently: true });
      copy.drawImage(c, 0, 0);
      const p = copy.getImageData(0, 0, c.width, c.height).data;
      let count = 0;
      for (let i = 0; i < p.length; i += 4) {
        if (p[i + 3] > 100 && Math.abs(p[i] - r) + Math.abs(p[i + 1] - g) + Math.abs(p[i + 2] - b) < 40) ++count;
      }
      return count;
    };
    const hidden = (layer, count) => {
      const before = count();
      page.querySelector(`input[name=${layer}]`).click();
      return before > 0 && count() === 0;
    };
    result.dataset.dynamic = hidden("labels", () => pixelsLike(230, 120, 0));
    result.dataset.followed = hidden("tracks", () => pixelsLike(170, 68, 153));
    const press = (key) => c.dispatchEvent(new frame.contentWindow.KeyboardEvent("keydown", { key }));
    press("ArrowDown");
    result.dataset.otherRun = page.querySelector("output").textContent;
    press("ArrowRight");
    result.dataset.later = page.querySelector("output").textContent;
  }
  const first = page.querySelector("table.sortable th[aria-sort]");
  result.dataset.sorted = first === null ? "" : first.getAttribute("aria-sort");
  // Texts of pictures that lie outside of them, by the box of each.
  let outside = "";
  for (const text of page.querySelectorAll("svg text")) {
    let picture = text.ownerSVGElement;
    while (picture.ownerSVGElement) picture = picture.ownerSVGElement;
    const a = text.getBoundingClientRect(), b = picture.getBoundingClientRect();
    if (a.left < b.left || a.right > b.right || a.top < b.top || a.bottom > b.bottom) outside += `${text.textContent}; `;
  }
  result.dataset.outside = outside;
  result.dataset.scrolls = String([...page.querySelectorAll(".wide")].some((x) => x.scrollWidth > x.clientWidth));
  result.dataset.tooWide = page.documentElement.scrollWidth - page.documentElement.clientWidth;
  result.dataset.text = page.documentElement.clientWidth;
});
</script>
)";
  return fmt::format(
      "<!DOCTYPE html><meta charset=\"utf-8\"><link rel=\"icon\" href=\"data:,\">"
      "<iframe style=\"border:0;width:{}px;height:900px\" srcdoc=\"{}\"></iframe>{}",
      width, xml_escaped(page), kUse);
}

struct Seen {
  std::string dom;      // of the outer page, after everything was done
  std::string console;  // what the browser had to say
};

Seen seen_in_browser(const std::string& page, int width) {
  const TemporaryFolder folder;
  write_text_file(folder.file("page.html"), framed(page, width));
  const std::string command = fmt::format(
      "cd '{0}' && timeout 100 chromium --headless --no-sandbox --disable-gpu --no-first-run "
      "--disable-background-networking --disable-component-update --disable-sync "
      "--disable-dev-shm-usage --user-data-dir='{0}/profile' --enable-logging=stderr "
      "--virtual-time-budget=5000 --window-size=1500,1000 --dump-dom 'file://{0}/page.html' "
      ">dom.txt 2>log.txt",
      folder.file(""));
  EXPECT_EQ(std::system(command.c_str()), 0) << read_text_file(folder.file("log.txt"));
  std::string log = read_text_file(folder.file("log.txt"));
  Seen seen{read_text_file(folder.file("dom.txt")), {}};
  std::string_view rest = log;
  while (!rest.empty()) {
    const std::string_view line = next_line(rest);
    if (line.find("CONSOLE") != std::string_view::npos) seen.console += std::string(line) + "\n";
  }
  return seen;
}

// The element that framed() leaves, without the page that is quoted in the frame.
std::string result_of(const Seen& seen) {
  const std::size_t begin = seen.dom.rfind("<p id=\"result\"");
  return begin == std::string::npos ? seen.dom
                                    : seen.dom.substr(begin, seen.dom.find('>', begin) - begin);
}

class Browser : public ::testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    if (!has_chromium()) GTEST_SKIP() << "there is no chromium here";
    make_example_results(folder_.file("example"));
    write_reports(folder_.file(""));
  }
  TemporaryFolder folder_;
};

TEST_P(Browser, ShowsAScenariosPage) {
  const Seen seen =
      seen_in_browser(read_text_file(folder_.file("example/report.html")), GetParam());
  EXPECT_EQ(seen.console, "");
  EXPECT_THAT(result_of(seen), HasSubstr("data-too-wide=\"0\""));
  EXPECT_THAT(result_of(seen), HasSubstr("data-scrolls=\"false\"")) << "tables stand in the page";
  EXPECT_THAT(result_of(seen), HasSubstr("data-sorted=\"descending\""));
  EXPECT_THAT(result_of(seen), HasSubstr("data-drawn=\"true\""));
  // What is called dynamic and who is followed are seen, until their boxes are cleared.
  EXPECT_THAT(result_of(seen), HasSubstr("data-dynamic=\"true\""));
  EXPECT_THAT(result_of(seen), HasSubstr("data-followed=\"true\""));
  // 5 s into the replays the estimate is 2 and 10 cm off for each of them.
  EXPECT_THAT(result_of(seen), HasSubstr("data-clock=\"5.0 s of 9.8 s, estimate off by 0.10 m\""));
  EXPECT_THAT(result_of(seen),
              HasSubstr("data-other-run=\"5.0 s of 9.8 s, estimate off by 0.50 m\""));
  EXPECT_THAT(result_of(seen), HasSubstr("data-later=\"6.0 s of 9.8 s, estimate off by 0.60 m\""));
}

TEST_P(Browser, ShowsTheOverview) {
  const Seen seen = seen_in_browser(read_text_file(folder_.file("report.html")), GetParam());
  EXPECT_EQ(seen.console, "");
  EXPECT_THAT(result_of(seen), HasSubstr("data-too-wide=\"0\""));
}

TEST_P(Browser, WouldTellOfErrorsAndOfWhatIsTooWide) {
  const Seen seen = seen_in_browser(
      "<!DOCTYPE html><div style=\"width:1600px\">wide</div><script>nobody.home();</script>",
      GetParam());
  EXPECT_THAT(seen.console, HasSubstr("nobody is not defined"));
  EXPECT_THAT(result_of(seen), Not(HasSubstr("data-too-wide=\"0\"")));
}

// Pictures whose texts are longer than there is room for.
std::vector<std::string> crowded_pictures() {
  const std::string very_long =
      "the error of the position over the length of the path that was driven ";
  Plot names{.title = very_long + very_long,
             .subtitle = very_long + very_long,
             .x = {.label = very_long + very_long, .unit = "m"},
             .y = {.label = very_long, .unit = "m"},
             .series = {{very_long + very_long, {0, 1, 2}, {-1e-4, 2e-4, -3e-4}},
                        {"AnotherNameWithoutAnyBlank", {0, 1, 2}, {1e-4, 2e-4, 3e-4}}}};
  names.x.categories = {very_long, "particle filter of many particles", very_long};
  const Plot numbers{.title = "Numbers",
                     .x = {.label = "length", .unit = "m", .high = 100000.0},
                     .y = {.label = "error", .unit = "m"},
                     .series = {{"WWWWWWWW MMMMMMMM", {0, 50000, 100000}, {-100000, 0, 200000}}}};
  const HeatMap heat{.title = "HeatMapsOfNamesWithoutAnyBlankThatAreTooLongForTheWholePicture",
                     .x = {.label = very_long},
                     .y = {.label = very_long},
                     .value = {.label = very_long, .unit = "m"},
                     .xs = {0, 10000},
                     .ys = {0, 1},
                     .values = {-0.0001, 0.0002, 0.0003, 0.0004}};
  const Matrix matrix{.title = "Matrix",
                      .rows = {very_long, "b"},
                      .columns = {{very_long, "c"}, {"d", very_long}, {very_long, "f"}},
                      .value = {.label = very_long, .unit = "m"},
                      .values = {1, 2, 3, 4, 5, 60000}};
  return {svg_of(names), svg_of(numbers), svg_of(heat), svg_of(matrix)};
}

class Fonts : public ::testing::TestWithParam<const char*> {};

TEST_P(Fonts, LeaveAllTextsOfPicturesWithinThem) {
  if (!has_chromium()) GTEST_SKIP() << "there is no chromium here";
  HtmlPage page{.title = "Pictures"};
  page.body =
      fmt::format("<style>svg text {{ font-family: '{}', sans-serif; }}</style>", GetParam());
  for (const std::string& picture : crowded_pictures()) {
    page.body += "<figure>" + figure_html(picture) + "</figure>\n";
  }
  const Seen seen = seen_in_browser(html_of(page), 360);
  EXPECT_EQ(seen.console, "");
  EXPECT_THAT(result_of(seen), HasSubstr("data-outside=\"\""));
  EXPECT_THAT(result_of(seen), HasSubstr("data-too-wide=\"0\""));
}

// As narrow as Helvetica, and a fifth wider.
INSTANTIATE_TEST_SUITE_P(Narrow, Fonts, ::testing::Values("Liberation Sans"));
INSTANTIATE_TEST_SUITE_P(Wide, Fonts, ::testing::Values("DejaVu Sans"));

INSTANTIATE_TEST_SUITE_P(Widths, Browser, ::testing::Values(360, 1440));

}  // namespace
}  // namespace mapbed
