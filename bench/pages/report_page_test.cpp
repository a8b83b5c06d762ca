#include <filesystem>

#include <gmock/gmock.h>

#include "bench/pages/html.h"
#include "bench/pages/pictures_html.h"
#include "bench/pages/reports.h"
#include "bench/pages/scenario_page.h"
#include "bench/pages/testing/example_results.h"
#include "bench/results/result_folder.h"
#include "core/file/hash.h"
#include "core/file/text_file.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

class ReportPage : public ::testing::Test {
 protected:
  ReportPage() { make_example_results(folder_.file("example")); }
  std::string page() const {
    const std::string folder = folder_.file("example");
    return scenario_page({folder, load_results(folder)});
  }
  TemporaryFolder folder_;
};

TEST_F(ReportPage, ShowsQuestionClaimsAndThesisSideBySide) {
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("<h1>Does &lt;b&gt; &amp; a question pass through?</h1>"));
  EXPECT_THAT(html, HasSubstr("Figure 3.10"));
  EXPECT_THAT(html, HasSubstr("1 of 2 claims held"));
  EXPECT_THAT(html, HasSubstr("<li>1 not judged</li>"));
  EXPECT_THAT(html, HasSubstr("0.1 against 0.3</td><td data-name=\"Thesis\">fewer at every level"));
}

TEST_F(ReportPage, CountsFailedRunsAndSaysWhyTheyFailed) {
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("1 of 2 runs failed"));
  EXPECT_THAT(html, HasSubstr("lost &lt;/script&gt;, at 3 s"));
}

TEST_F(ReportPage, ShowsAnglesInDegreesAndTheExactValueAsToolTip) {
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr(">28.65</span>")) << "0.5 rad";
  EXPECT_THAT(html, HasSubstr("<td data-name=\"unit\" class=\"short\">deg</td>"));
  EXPECT_THAT(html, HasSubstr("<span title=\"0.125\">0.125</span>"));
  EXPECT_THAT(html, HasSubstr("0.4 to 0.6"));
}

TEST_F(ReportPage, NeedsNothingFromElsewhere) {
  const std::string html = page();
  EXPECT_THAT(html, Not(HasSubstr("src=\"http")));
  EXPECT_THAT(html, Not(HasSubstr("@import")));
  EXPECT_EQ(count(html, "<script"), 2u) << "the page's and the replay's data";
  EXPECT_EQ(count(html, "</script>"), 2u) << "and no text ends one";
  EXPECT_EQ(count(html, "<figure>"), 3u);
  EXPECT_EQ(count(html, "<canvas"), 1u);
}

TEST_F(ReportPage, SaysInWordsWhatAMapAndAReplayAreOf) {
  EXPECT_THAT(page(), HasSubstr("<figcaption>map, rotation sigma 16 deg, off</figcaption>"));
  EXPECT_THAT(page(), HasSubstr(">seed 7 &lt;/script&gt;, rotation sigma 0 deg, off</option>"));
}

TEST_F(ReportPage, FindsThePicturesOfOlderResultsByTheirNames) {
  std::filesystem::remove(folder_.file("example/files.csv"));
  EXPECT_THAT(page(), HasSubstr("<figcaption>map, rotation sigma 16 deg, off</figcaption>"));
}

TEST_F(ReportPage, ShowsTheScenariosPlotsFirstAndThenSingleRunsAsPeopleSort) {
  const std::string folder = folder_.file("example");
  Results results = load_results(folder);
  results.plots = {{.file = "success"}, {.file = "error"}, {.file = "not_drawn"}};
  results.files = {{"figures/after_130_s.svg", 0, ""},
                   {"figures/after_90_s.svg", 0, ""},
                   {"figures/not_kept.svg", 0, ""}};
  for (const char* name : {"after_130_s", "after_90_s", "success"}) {
    write_text_file(folder + "/figures/" + name + ".svg", "<svg/>");
  }
  std::vector<std::string> paths;
  for (const Picture& figure : figures_of({folder, results})) paths.push_back(figure.path);
  EXPECT_THAT(paths, ElementsAre("figures/success.svg", "figures/error.svg",
                                 "figures/after_90_s.svg", "figures/after_130_s.svg"));
}

TEST_F(ReportPage, HoldsOneViewerForAllRunsAndOnceWhatTheyShare) {
  const std::string html = page();
  EXPECT_EQ(count(html, "<canvas"), 1u);
  EXPECT_EQ(count(html, "<option value=\"1\">seed 7"), 1u);
  EXPECT_EQ(count(html, "[0.0,0.0,20.0,0.0,"), 1u) << "the walls of both runs";
  EXPECT_EQ(count(html, "\"title\":\"seed 7"), 2u);
}

TEST_F(ReportPage, OfASingleReplayHasNoChoiceOfRuns) {
  std::filesystem::remove(folder_.file("example/replays/run_level_1_off.json"));
  EXPECT_THAT(page(), Not(HasSubstr("<select name=\"run\"")));
  EXPECT_THAT(page(), HasSubstr("<h3>seed 7 &lt;/script&gt;, rotation sigma 0 deg, off</h3>"));
}

TEST_F(ReportPage, ComesWithoutTheReplayPlayerWhereThereIsNoReplay) {
  std::filesystem::remove_all(folder_.file("example/replays"));
  EXPECT_THAT(page(), Not(HasSubstr("canvas.getContext")));
}

TEST_F(ReportPage, OfAllResultsLinksThePageOfEach) {
  EXPECT_THAT(write_reports(folder_.file("")),
              ElementsAre(folder_.file("example/report.html"), folder_.file("report.html"),
                          folder_.file("README.md")));
  EXPECT_THAT(read_text_file(folder_.file("report.html")),
              HasSubstr("href=\"example/report.html\""));
  const std::string markdown = read_text_file(folder_.file("README.md"));
  EXPECT_THAT(markdown, HasSubstr("| [example](example/) | Does \\<b\\> & a question pass through? "
                                  "| Figure 3.10 | 1 of 2 | 1 of 2 |"));
  EXPECT_THAT(markdown, HasSubstr("![Error over noise](example/figures/error.svg)"));
}

TEST_F(ReportPage, OfSomebodyElseIsNotWrittenOver) {
  write_text_file(folder_.file("README.md"), "# Of my own\n");
  EXPECT_INPUT_ERROR(write_reports(folder_.file("")), "README.md: was not written by mapbed");
  EXPECT_FALSE(std::filesystem::exists(folder_.file("report.html"))) << "nor is any other";
  EXPECT_FALSE(std::filesystem::exists(folder_.file("example/report.html")));
  std::filesystem::remove(folder_.file("README.md"));
  write_reports(folder_.file(""));
  EXPECT_NO_THROW(write_reports(folder_.file(""))) << "its own are";
  for (const char* page : {"report.html", "example/report.html"}) {
    const std::string ours = read_text_file(folder_.file(page));
    write_text_file(folder_.file(page), "<html><body>Of my own</body></html>\n");
    EXPECT_INPUT_ERROR(write_reports(folder_.file("")), "report.html: was not written by mapbed");
    write_text_file(folder_.file(page), ours);
  }
}

TEST_F(ReportPage, WhereOneCannotBeWrittenNothingChanges) {
  std::filesystem::copy(folder_.file("example"), folder_.file("other"),
                        std::filesystem::copy_options::recursive);
  write_text_file(folder_.file("other/.publication"), "is in the way");
  write_text_file(folder_.file("example/figures/error.svg"), "<svg>of old</svg>");
  EXPECT_INPUT_ERROR(write_reports(folder_.file("")), "other/.publication");
  EXPECT_EQ(read_text_file(folder_.file("example/figures/error.svg")), "<svg>of old</svg>");
  EXPECT_EQ(folder_.files(), 2u) << "no overview, and no litter";
  for (const char* name : {"example/report.html", "example/.publication"}) {
    EXPECT_FALSE(std::filesystem::exists(folder_.file(name))) << name;
  }
}

TEST_F(ReportPage, AResultAtWhichARunIsAtWorkIsShownAndNotTouched) {
  write_text_file(folder_.file("example/figures/error.svg"), "<svg>of old</svg>");
  EXPECT_THAT(write_reports(folder_.file(""), {folder_.file("example")}),
              ElementsAre(folder_.file("report.html"), folder_.file("README.md")));
  EXPECT_EQ(read_text_file(folder_.file("example/figures/error.svg")), "<svg>of old</svg>");
  EXPECT_THAT(read_text_file(folder_.file("report.html")), HasSubstr("of old"));
  write_reports(folder_.file(""));
  EXPECT_THAT(read_text_file(folder_.file("report.html")), Not(HasSubstr("of old")));
}

TEST_F(ReportPage, LeavesTablesOfRunsAsAnOlderProgramWroteThem) {
  const std::string cost =
      "run,seconds,recording_seconds,method_seconds,recorded_seconds,peak_memory_bytes\n"
      "0,1.5,3.0,0.0,60.0,100000000\n2,0.5,0.0,0.0,60.0,120000000\n";
  write_text_file(folder_.file("example/cost.csv"), cost);
  write_text_file(folder_.file("example/provenance.json"),
                  "{\"tables_sha256\": {\"cost.csv\": \"" + sha256(cost) + "\"}}\n");
  write_reports(folder_.file("example"));
  EXPECT_EQ(read_text_file(folder_.file("example/cost.csv")), cost);
  EXPECT_NO_THROW(load_results(folder_.file("example")));
}

TEST_F(ReportPage, TheSameResultsAreTheSamePage) {
  EXPECT_EQ(page(), page());
}

TEST_F(ReportPage, RefusesFoldersWithoutResultsAndDamagedFiles) {
  EXPECT_INPUT_ERROR(write_reports(folder_.file("nowhere")), "there is no such folder");
  EXPECT_INPUT_ERROR(write_reports(folder_.file("example/maps")), "holds no results");
  EXPECT_INPUT_ERROR(load_results(folder_.file("")), "make one with 'mapbed run SCENARIO'");
  write_text_file(folder_.file("example/replays/run_level_0_off.json"), "[1,");
  EXPECT_INPUT_ERROR(page(), "run_level_0_off.json: is not a replay");
  write_text_file(folder_.file("example/summary.csv"), "a,b\n1\n");
  EXPECT_INPUT_ERROR(load_results(folder_.file("example")), "summary.csv:2");
}

}  // namespace
}  // namespace mapbed
