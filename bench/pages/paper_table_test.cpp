#include "bench/pages/paper_table.h"

#include <cstdlib>
#include <filesystem>
#include <limits>

#include <gmock/gmock.h>

#include "bench/results/sweep.h"
#include "core/file/text_file.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Two variants under two noises, two metrics; nothing has a value but what a test gives one.
Results noise() {
  Results r{.id = "noise_50%"};
  r.axes = {axis_of("robot.odometry.rotation_sigma", {"0 deg", "16 deg"})};
  r.levels = levels_of(r.axes);
  r.variants = {"raw_odometry", "matched & refined"};
  r.metrics = {{"translation_error", Unit::meter, ""}, {"heading_error", Unit::radian, ""}};
  return r;
}

SummaryRow row(int level, int variant, int metric, double mean, double low, double high) {
  return {.level = level,
          .variant = variant,
          .metric = metric,
          .runs = 10,
          .mean = mean,
          .low = low,
          .high = high};
}

TEST(PaperTable, HasVariantsSideBySideAndARowForEachLevel) {
  Results results = noise();
  results.summary = {row(0, 0, 0, 0.5, 0.4, 0.6), row(0, 1, 0, 0.125, 0.125, 0.125),
                     row(1, 0, 0, 2.0, 1.0, 3.0), row(1, 1, 0, kNone, kNone, kNone)};
  results.summary.back().failed = 10;
  const std::vector<PaperTable> tables = paper_tables(results, {"translation_error"});
  ASSERT_THAT(tables, SizeIs(1));
  EXPECT_EQ(tables[0].about, "translation error [m], mean of 10 runs with its 95 % interval");
  EXPECT_EQ(markdown_of(tables[0]),
            "translation error \\[m\\], mean of 10 runs with its 95 % interval:\n\n"
            "| rotation sigma | raw\\_odometry | matched & refined |\n"
            "| --- | ---: | ---: |\n"
            "| 0 deg | 0.5 \\[0.4, 0.6\\] | 0.125 |\n"
            "| 16 deg | 2 \\[1, 3\\] | \u2013 (10 failed) |\n");
}

TEST(PaperTable, HasMetricsSideBySideWhereThereIsOneLevel) {
  Results results = noise();
  results.axes.clear();
  results.levels = levels_of({});
  results.summary = {row(0, 0, 0, 0.5, 0.5, 0.5), row(0, 0, 1, 3.14159265358979, 3.1, 3.2),
                     row(0, 1, 0, 0.1, 0.1, 0.1), row(0, 1, 1, 0.0, 0.0, 0.0)};
  const std::vector<PaperTable> tables = paper_tables(results, {});
  ASSERT_THAT(tables, SizeIs(1));
  EXPECT_THAT(tables[0].head,
              ElementsAre("variant", "translation error [m]", "heading error [deg]"));
  EXPECT_THAT(tables[0].rows, ElementsAre(ElementsAre("raw_odometry", "0.5", "180 [178, 183]"),
                                          ElementsAre("matched & refined", "0.1", "0")));
}

TEST(PaperTable, LeavesOutWhatHasNoValue) {
  Results results = noise();
  results.summary = {row(0, 1, 0, 0.5, 0.5, 0.5), row(0, 1, 1, kNone, kNone, kNone)};
  const std::vector<PaperTable> tables = paper_tables(results, {});
  ASSERT_THAT(tables, SizeIs(1)) << "none of heading errors";
  EXPECT_THAT(tables[0].head, ElementsAre("rotation sigma", "matched & refined"));
  EXPECT_THAT(tables[0].rows, ElementsAre(ElementsAre("0 deg", "0.5")));
}

TEST(PaperTable, IsNotMadeOfWhatWasNotMeasured) {
  EXPECT_INPUT_ERROR(paper_tables(noise(), {"translation_eror"}),
                     "did you mean 'translation_error'?");
}

TEST(PaperTable, NoTextBreaksLatexOrMarkdown) {
  EXPECT_EQ(latex_escaped("50% of a_b & c#1 {$} ~^\\"),
            "50\\% of a\\_b \\& c\\#1 \\{\\$\\} \\textasciitilde{}\\textasciicircum{}"
            "\\textbackslash{}");
  EXPECT_EQ(latex_escaped("\u22123 \u00B0"), "$-$3 $^\\circ$");
  EXPECT_EQ(latex_escaped("[m]"), "{}[m]") << "after a line break it would be an option of it";
  EXPECT_EQ(markdown_escaped("a|b\n<i>*"), "a\\|b \\<i\\>\\*");
}

TEST(PaperTable, LatexTypesetsIt) {
  if (std::system("command -v pdflatex >/dev/null 2>&1") != 0) GTEST_SKIP() << "no pdflatex here";
  Results results = noise();
  results.summary = {row(0, 0, 0, -0.5, -0.6, -0.4), row(1, 1, 1, 0.1, 0.1, 0.2)};
  std::string document = "\\documentclass{article}\\usepackage{booktabs}\\begin{document}\n";
  for (const PaperTable& table : paper_tables(results, {})) document += latex_of(table) + "\n";
  const TemporaryFolder folder;
  write_text_file(folder.file("t.tex"), document +
                                            latex_escaped("\\{}$&#%_^~<>\u2212\u2013\u00B0"
                                                          "\u00B2\u00B5\u00D7") +
                                            "\n\\end{document}\n");
  const std::string command = "cd '" + folder.file("") +
                              "' && pdflatex -halt-on-error -interaction=batchmode t.tex >out.txt";
  EXPECT_EQ(std::system(command.c_str()), 0) << read_text_file(folder.file("t.log"));
  EXPECT_TRUE(std::filesystem::exists(folder.file("t.pdf")));
}

}  // namespace
}  // namespace mapbed
