#include "bench/results/figures.h"

#include <filesystem>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>

#include "core/file/text_file.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

SummaryRow row(int level, int variant, double mean) {
  return {.level = level,
          .variant = variant,
          .metric = 0,
          .runs = 3,
          .mean = mean,
          .low = mean / 2,
          .high = 2 * mean};
}

// Two levels of noise, a filter off and on, three runs each.
Results sweep() {
  Results results;
  results.axes = {{"odometry.sigma", {"0 deg", "2 deg"}, {0, 2}, "deg"}};
  results.levels = {{{0}}, {{1}}};
  results.variants = {"off", "on"};
  results.metrics = {{"heading_error", Unit::radian, ""}};
  results.summary = {row(0, 0, 1.0), row(0, 1, 0.5), row(1, 0, 2.0), row(1, 1, 1.0)};
  return results;
}

TEST(Figures, LinesOverASweepOneForEachVariant) {
  Results results = sweep();
  results.summary[0].failed = 2;
  results.summary[3].missing = 1;
  const Plot plot =
      figure_of(results, {.title = "Noise", .x = "odometry.sigma", .y = "heading_error"});
  EXPECT_EQ(title_of(plot.x), "sigma [deg]");
  EXPECT_EQ(title_of(plot.y), "heading error [deg]");
  ASSERT_EQ(plot.series.size(), 2u);
  EXPECT_EQ(plot.series[0].name, "off");
  EXPECT_THAT(plot.series[0].x, ElementsAre(0.0, 2.0));
  const double degrees = 180.0 / std::numbers::pi;
  EXPECT_THAT(plot.series[0].y, ElementsAre(degrees, 2 * degrees));
  EXPECT_THAT(plot.series[1].low, ElementsAre(0.25 * degrees, 0.5 * degrees));
  EXPECT_THAT(plot.subtitle, HasSubstr("mean of 3 runs each"));
  EXPECT_THAT(plot.subtitle, HasSubstr("2 of 12 runs failed"));
  EXPECT_THAT(plot.subtitle, HasSubstr("1 without a value left out"));
}

TEST(Figures, BarsOfTheVariantsSideBySide) {
  const Plot plot = figure_of(sweep(), {.kind = PlotKind::bars, .y = "heading_error"});
  EXPECT_THAT(plot.x.categories, ElementsAre("off", "on"));
  ASSERT_EQ(plot.series.size(), 2u) << "one for each level";
  EXPECT_EQ(plot.series[1].name, "sigma 2 deg");
  EXPECT_THAT(plot.series[1].x, ElementsAre(0.0, 1.0));
  EXPECT_EQ(plot.series[1].mark, Mark::bars);
}

TEST(Figures, NamesAreNotJoinedByLinesNorHaveLogarithmicBarsAFoot) {
  for (const PlotSpec& spec :
       {PlotSpec{.y = "heading_error"},
        PlotSpec{.kind = PlotKind::bars, .y = "heading_error", .log_y = true}}) {
    const Plot plot = figure_of(sweep(), spec);
    EXPECT_EQ(plot.series[0].mark, Mark::points);
    EXPECT_THAT(plot.subtitle, HasSubstr("error bar"));
  }
}

TEST(Figures, OnlyTheVariantsAskedFor) {
  const Plot plot =
      figure_of(sweep(), {.x = "odometry.sigma", .y = "heading_error", .variants = {"on"}});
  ASSERT_EQ(plot.series.size(), 1u);
  EXPECT_EQ(plot.series[0].name, "on");
}

TEST(Figures, NoIntervalOfASingleRun) {
  Results results = sweep();
  for (SummaryRow& summary : results.summary) summary.runs = 1;
  const Plot plot = figure_of(results, {.x = "odometry.sigma", .y = "heading_error"});
  EXPECT_THAT(plot.series[0].low, IsEmpty());
  EXPECT_THAT(plot.subtitle, HasSubstr("one run each"));
}

TEST(Figures, PointsAreRunsOneMetricOverAnother) {
  Results results = sweep();
  results.metrics.push_back({"length", Unit::meter, ""});
  results.runs = {{.level = 0, .variant = 0, .values = {0.0, 5.0}},
                  {.level = 0, .variant = 0, .values = {kNaN, 6.0}, .failure = "lost"}};
  const Plot plot =
      figure_of(results, {.kind = PlotKind::points, .x = "length", .y = "heading_error"});
  ASSERT_EQ(plot.series.size(), 1u);
  EXPECT_THAT(plot.series[0].x, ElementsAre(5.0, 6.0));
  EXPECT_THAT(plot.subtitle, HasSubstr("1 of 2 runs failed; 1 without a value left out"));
}

TEST(Figures, ReferencesAreShownInTheUnitOfTheAxis) {
  const Plot plot = figure_of(
      sweep(),
      {.x = "odometry.sigma", .y = "heading_error", .references = {{"published", "90 deg"}}});
  ASSERT_EQ(plot.references.size(), 1u);
  EXPECT_NEAR(plot.references[0].y, 90.0, 1e-9);
  EXPECT_EQ(plot.references[0].name, "published");
}

// Of two axes, the second one in falling order.
TEST(Figures, AHeatMapHasTheMeansInTheOrderOfItsSides) {
  Results results = sweep();
  results.variants = {"all"};
  results.metrics = {{"distance", Unit::meter, ""}};
  results.axes.push_back({"people", {"5", "0"}, {5, 0}, ""});
  results.levels = {{{0, 0}}, {{0, 1}}, {{1, 0}}, {{1, 1}}};
  results.summary = {row(0, 0, 1.0), row(1, 0, 2.0), row(2, 0, 3.0), row(3, 0, 4.0)};
  results.summary[2].failed = 1;
  const HeatMap map = heat_map_of(
      results,
      {.kind = PlotKind::heat_map, .x = "odometry.sigma", .y = "people", .value = "distance"});
  EXPECT_THAT(map.xs, ElementsAre(0.0, 2.0));
  EXPECT_THAT(map.ys, ElementsAre(0.0, 5.0));
  EXPECT_THAT(map.values, ElementsAre(2.0, 4.0, 1.0, 3.0));
  EXPECT_EQ(title_of(map.x), "sigma [deg]");
  EXPECT_EQ(title_of(map.value), "distance [m]");
  EXPECT_EQ(map.subtitle, "mean of 3 runs each; 1 of 12 runs failed");
}

// Two logs, broken in two ways, by two methods; the second method was not run on the second log.
TEST(Figures, AMatrixHasRowsOfOneAxisAndColumnsOfTheOtherWithTheVariants) {
  Results results;
  results.axes = {{"log", {"near", "far"}, {}, ""}, {"fault", {"none", "stall"}, {}, ""}};
  results.levels = levels_of(results.axes);
  results.variants = {"a", "b"};
  results.metrics = {{"error", Unit::meter, ""}, {"told", Unit::none, ""}};
  for (int level = 0; level < 4; ++level) {
    for (int variant = 0; variant < 2; ++variant) {
      results.summary.push_back(row(level, variant, 10.0 * level + variant));
      results.summary.push_back(row(level, variant, level == 1 && variant == 0 ? 1.0 : 0.0));
      results.summary.back().metric = 1;
    }
  }
  for (SummaryRow& of : results.summary) {
    if (of.level >= 2 && of.variant == 1) of.runs = 0;
  }
  const PlotSpec spec{.kind = PlotKind::matrix,
                      .x = "log",
                      .y = "fault",
                      .value = "error",
                      .mark = "told",
                      .value_range = {"1 cm", "10 m"},
                      .log_value = true};
  const Matrix matrix = matrix_of(results, spec);
  EXPECT_THAT(matrix.rows, ElementsAre("none", "stall"));
  std::string columns;
  for (const Matrix::Column& column : matrix.columns) columns += column.group + column.name + " ";
  EXPECT_EQ(columns, "neara nearb fara farb ");
  // Levels: near none, near stall, far none, far stall.
  EXPECT_THAT(matrix.values, ElementsAre(0.0, 1.0, 20.0, ::testing::IsNan(),  //
                                         10.0, 11.0, 30.0, ::testing::IsNan()));
  EXPECT_THAT(matrix.marks, ElementsAre(0, 0, 0, 0, 1, 0, 0, 0));
  EXPECT_EQ(matrix.value.low, 0.01);
  EXPECT_EQ(matrix.value.high, 10.0);
  EXPECT_TRUE(matrix.value.logarithmic);
  EXPECT_EQ(title_of(matrix.value), "error [m]");
}

TEST(Figures, IntervalsOfWhatIsZeroOrOneAreWilsons) {
  Results results = sweep();
  for (SummaryRow& of : results.summary) {
    of.mean = of.low = of.high = 0.0;  // it never came
    of.runs = 50;
  }
  const Plot plot = figure_of(
      results,
      {.x = "odometry.sigma", .y = "heading_error", .variants = {"on"}, .is_binomial = true});
  ASSERT_EQ(plot.series.size(), 1U);
  EXPECT_EQ(plot.series[0].low[0], 0.0);
  // z^2 / (n + z^2), shown in degrees as the metric is.
  EXPECT_NEAR(plot.series[0].high[0], 3.8414588 / 53.8414588 * 180.0 / std::numbers::pi, 1e-6);
  EXPECT_THAT(plot.subtitle, ::testing::HasSubstr("95 % Wilson interval of the fraction"));
}

TEST(Figures, AMatrixOfMetricsHasARowForEachInTheirOrder) {
  Results results;
  results.levels = levels_of({});
  results.variants = {"a", "b", "c"};
  results.metrics = {{"of_people", Unit::none, ""}, {"of_doors", Unit::none, ""}};
  for (int variant = 0; variant < 3; ++variant) {
    results.summary.push_back(row(0, variant, 0.1 * variant));
    results.summary.push_back(row(0, variant, 0.5 + 0.1 * variant));
    results.summary.back().metric = 1;
  }
  results.summary[3].runs = 0;  // of doors in 'b' there was no value
  const Matrix matrix = matrix_of(
      results,
      {.kind = PlotKind::matrix, .rows = {"of_doors", "of_people"}, .variants = {"a", "b"}});
  EXPECT_THAT(matrix.rows, ElementsAre("of doors", "of people"));
  ASSERT_EQ(matrix.columns.size(), 2U);
  EXPECT_EQ(matrix.columns[1].name, "b");
  EXPECT_THAT(matrix.values, ElementsAre(0.5, ::testing::IsNan(), 0.0, 0.1));
}

TEST(Figures, AMatrixOfOneAxisHasTheVariantsAsColumns) {
  const Matrix matrix = matrix_of(sweep(), {.kind = PlotKind::matrix,
                                            .y = "odometry.sigma",
                                            .value = "heading_error",
                                            .variants = {"on"}});
  EXPECT_THAT(matrix.rows, ElementsAre("0 deg", "2 deg"));
  ASSERT_EQ(matrix.columns.size(), 1u);
  EXPECT_EQ(matrix.columns[0].name, "on");
  const double degrees = 180.0 / std::numbers::pi;
  EXPECT_THAT(matrix.values, ElementsAre(0.5 * degrees, degrees));
  EXPECT_THAT(matrix.marks, IsEmpty());
}

TEST(Figures, OnlyTheLevelsAskedFor) {
  const Plot plot =
      figure_of(sweep(), {.y = "heading_error", .at = {{"odometry.sigma", {"2 deg"}}}});
  ASSERT_EQ(plot.series.size(), 1u);
  const double degrees = 180.0 / std::numbers::pi;
  EXPECT_THAT(plot.series[0].y, ElementsAre(2 * degrees, degrees));
  EXPECT_THAT(plot.subtitle, HasSubstr("; sigma 2 deg"));
}

TEST(Figures, AreWrittenWithTheirNumbers) {
  const TemporaryFolder folder;
  Results results = sweep();
  results.plots = {{.file = "noise", .x = "odometry.sigma", .y = "heading_error"}};
  write_figures(folder.file(""), results);
  EXPECT_THAT(read_text_file(folder.file("figures/noise.svg")), HasSubstr("heading error [deg]"));
  EXPECT_THAT(read_text_file(folder.file("figures/noise.csv")), HasSubstr("off,0,"));
}

}  // namespace
}  // namespace mapbed
