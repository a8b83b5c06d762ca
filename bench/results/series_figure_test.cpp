#include "bench/results/series_figure.h"

#include <numbers>

#include <gmock/gmock.h>

namespace mapbed {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Two variants with two runs each; the second run's values are three times those of the first.
Results iterations() {
  Results r;
  r.levels = {{}};
  r.variants = {"points", "planes"};
  r.series_metrics = {{"residual", Unit::radian, "iteration", Unit::none, ""}};
  for (int run = 0; run < 4; ++run) {
    const double scale = (run < 2 ? 1.0 : 3.0) * (run % 2 == 0 ? 1.0 : 0.1);
    r.runs.push_back({.run = run, .variant = run % 2});
    r.series.push_back({"residual", {{0, scale}, {1, scale / 2}, {2, scale / 4}}, run});
  }
  return r;
}

const PlotSpec kSpec{.title = "Convergence", .kind = PlotKind::series, .y = "residual"};

TEST(SeriesFigure, IsTheMeanOverTheRunsOfEachVariant) {
  const Plot plot = series_figure_of(iterations(), kSpec);
  EXPECT_EQ(title_of(plot.x), "iteration");
  EXPECT_EQ(title_of(plot.y), "residual [deg]");
  ASSERT_EQ(plot.series.size(), 2u);
  EXPECT_EQ(plot.series[1].name, "planes");
  EXPECT_EQ(plot.series[1].mark, Mark::line);
  EXPECT_THAT(plot.series[0].x, ElementsAre(0.0, 1.0, 2.0));
  const double degrees = 180.0 / std::numbers::pi;
  EXPECT_THAT(plot.series[0].y,
              ElementsAre(DoubleNear(2 * degrees, 1e-12), DoubleNear(degrees, 1e-12),
                          DoubleNear(degrees / 2, 1e-12)));
  // All resamples of two values lie between them, and one in four is a value twice.
  EXPECT_NEAR(plot.series[0].low[0], degrees, 1e-12);
  EXPECT_NEAR(plot.series[0].high[0], 3 * degrees, 1e-12);
  EXPECT_EQ(plot.subtitle, "mean of 2 runs each, band: 95 % bootstrap interval of the mean");
}

TEST(SeriesFigure, RunsAtOtherTimesAreComparedAtEvenSteps) {
  Results r = iterations();
  r.series_metrics[0].x_unit = Unit::second;
  r.variants = {"all"};
  r.runs = {{.run = 0}, {.run = 1}};
  r.series = {{"residual", {{0.0, 0.0}, {1.0, 1.0}, {2.0, 2.0}}, 0},
              {"residual", {{0.0, 0.0}, {0.9, 1.8}, {2.0, 4.0}}, 1}};
  const Plot plot = series_figure_of(r, kSpec);
  ASSERT_EQ(plot.series.size(), 1u);
  EXPECT_THAT(plot.series[0].x, ElementsAre(0.0, 1.0, 2.0));
  const double degrees = 180.0 / std::numbers::pi;
  EXPECT_NEAR(plot.series[0].y[1], 1.5 * degrees, 1e-12);
}

// Of two runs the one that is higher on the whole settles first: without it the mean would fall.
TEST(SeriesFigure, OverIterationsARunThatSettledStaysInTheMean) {
  Results r = iterations();
  r.variants = {"all"};
  r.series_metrics[0].unit = Unit::none;
  r.runs = {{.run = 0}, {.run = 1}};
  r.series = {{"residual", {{0, 10.0}, {1, 12.0}}, 0},
              {"residual", {{0, 0.0}, {1, 2.0}, {2, 3.0}, {3, 3.5}}, 1}};
  const Plot plot = series_figure_of(r, kSpec);
  ASSERT_EQ(plot.series.size(), 1u);
  EXPECT_THAT(plot.series[0].y, ElementsAre(5.0, 7.0, 7.5, 7.75));
  EXPECT_THAT(plot.subtitle, HasSubstr("1 runs end earlier than others and count with their last"));
}

TEST(SeriesFigure, CountsRunsThatFailHaveNoSeriesOrEndBefore) {
  Results r = iterations();
  r.runs[1].failure = "no match";
  r.series[3].points.pop_back();
  r.series.erase(r.series.begin());
  const Plot plot = series_figure_of(r, kSpec);
  EXPECT_THAT(plot.subtitle, HasSubstr("1 of 4 runs failed"));
  EXPECT_THAT(plot.subtitle, HasSubstr("1 without a value left out"));
  EXPECT_THAT(plot.subtitle, HasSubstr("1 runs end earlier than others"));
  EXPECT_EQ(plot.series[1].x.size(), 3u);
}

TEST(SeriesFigure, OfASingleRunHasNoInterval) {
  Results r = iterations();
  r.runs.resize(2);
  const Plot plot = series_figure_of(r, kSpec);
  EXPECT_THAT(plot.series[0].low, IsEmpty());
  EXPECT_THAT(plot.subtitle, HasSubstr("one run each"));
}

}  // namespace
}  // namespace mapbed
