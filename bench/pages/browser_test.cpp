// Opens pages in a real browser, headless, as wide as a telephone and as a desktop: no console
// message, nothing wider than the window, and the controls work. Skipped where there is no
// Chromium.

#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "bench/pages/reports.h"
#include "bench/pages/testing/example_results.h"
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
  }
  const first = page.querySelector("table.sortable th[aria-sort]");
  result.dataset.sorted = first === null ? "" : first.getAttribute("aria-sort");
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
  EXPECT_THAT(result_of(seen), HasSubstr("data-sorted=\"descending\""));
  EXPECT_THAT(result_of(seen), HasSubstr("data-drawn=\"true\""));
  // 5 s into the replay the estimate is 2 cm off for each of them.
  EXPECT_THAT(result_of(seen), HasSubstr("data-clock=\"5.0 s of 9.8 s, estimate off by 0.10 m\""));
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

INSTANTIATE_TEST_SUITE_P(Widths, Browser, ::testing::Values(390, 1440));

}  // namespace
}  // namespace mapbed
