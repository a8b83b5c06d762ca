#include "bench/plot/plot.h"

#include <limits>

#include <gmock/gmock.h>

#include "bench/plot/series_style.h"
#include "bench/plot/testing/well_formed.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

Plot two_lines() {
  return {.title = "Failures <grow> & grow",
          .subtitle = "mean of 50 runs",
          .x = {"noise", "deg"},
          .y = {"failures"},
          .series = {{"filter off", {0, 1, 2}, {1, 2, 4}, {0.5, 1.5, 3}, {2, 3, 5}},
                     {"filter on", {0, 1, 2}, {1, 1, 2}}}};
}

TEST(Plot, IsWellFormedXmlWithAllNames) {
  const std::string svg = svg_of(two_lines());
  EXPECT_TRUE(is_well_formed(svg)) << svg;
  for (const char* text : {"filter off", "filter on", "noise [deg]", ">failures<",
                           "mean of 50 runs", "Failures &lt;grow&gt; &amp; grow"}) {
    EXPECT_THAT(svg, HasSubstr(text));
  }
  EXPECT_EQ(count(svg, "class=\"series\""), 2u);
  EXPECT_EQ(count(svg, "Z\" fill="), 1u) << "one band";
}

TEST(Plot, BreaksALineWhereThereIsNoValue) {
  Plot plot{.series = {{"a", {0, 1, 2, 3, 4}, {1, 1, kNaN, 1, 1}}}};
  const std::string svg = svg_of(plot);
  EXPECT_TRUE(is_well_formed(svg));
  const std::size_t line = svg.find("<path d=\"M", svg.find("class=\"series\""));
  const std::string data = svg.substr(line, svg.find("\" fill", line) - line);
  EXPECT_EQ(count(data, "M"), 2u) << data;
  EXPECT_EQ(count(data, "L"), 2u) << data;
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(Plot, OfNoValuesSaysSo) {
  for (const Mark mark : {Mark::line, Mark::points, Mark::bars}) {
    const PlotSeries nothing{.name = "a", .x = {0.0}, .y = {kNaN}, .mark = mark};
    const std::string svg = svg_of(Plot{.series = {nothing}});
    EXPECT_TRUE(is_well_formed(svg));
    EXPECT_THAT(svg, HasSubstr("no values"));
  }
  EXPECT_THAT(svg_of(two_lines()), Not(HasSubstr("no values")));
  EXPECT_TRUE(is_well_formed(svg_of(Plot{})));
}

TEST(Plot, ZeroIsAGapOnALogarithmicAxis) {
  Plot plot = two_lines();
  plot.x.logarithmic = true;
  plot.y.logarithmic = true;
  const std::string svg = svg_of(plot);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
  EXPECT_THAT(svg, HasSubstr("2 at 0 or below")) << "x = 0 of both lines";
  EXPECT_THAT(svg_of(two_lines()), Not(HasSubstr("at 0 or below")));
}

TEST(Plot, BarsOfOnePlaceStandSideBySideFromZero) {
  Plot plot = two_lines();
  plot.x.categories = {"museum", "office", "a corridor with a very long name"};
  for (PlotSeries& series : plot.series) series.mark = Mark::bars;
  plot.series[1].y = {-1.0, 1.0, kNaN};
  const std::string svg = svg_of(plot);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_EQ(count(svg, "fill=\"url(#bar-"), 3u + 2u + 2u) << "and two in the legend";
  EXPECT_EQ(count(svg, "<pattern "), 2u);
  EXPECT_THAT(svg, HasSubstr("a corridor with a very long name"));
}

TEST(Plot, ReferencesStandInTheLegend) {
  Plot plot = two_lines();
  plot.references = {{"thesis", 8.0}};
  const std::string svg = svg_of(plot);
  EXPECT_THAT(svg, HasSubstr(">thesis<"));
  EXPECT_THAT(svg, HasSubstr(">8<")) << "the axis reaches it";
}

TEST(Plot, TheSamePlotIsTheSameBytes) {
  EXPECT_EQ(svg_of(two_lines()), svg_of(two_lines()));
}

TEST(Plot, ItsTableHasEveryNumber) {
  Plot plot = two_lines();
  plot.x.categories = {"none", "some", "much"};
  plot.series[1].y[2] = kNaN;
  EXPECT_EQ(csv_of(plot),
            "series,noise [deg],failures,low,high\n"
            "filter off,none,1,0.5,2\nfilter off,some,2,1.5,3\nfilter off,much,4,3,5\n"
            "filter on,none,1,,\nfilter on,some,1,,\nfilter on,much,,,\n");
}

TEST(SeriesStyle, NeighboursDifferWithoutColourToo) {
  for (int i = 0; i < 20; ++i) {
    const SeriesStyle a = series_style(i), b = series_style(i + 1);
    EXPECT_NE(a.color, b.color);
    EXPECT_NE(a.dash, b.dash);
    EXPECT_NE(a.marker, b.marker);
    EXPECT_NE(a.hatching, b.hatching);
  }
}

// Of the one rectangle without filling: the area of the data.
double attribute_of_area(const std::string& svg, const std::string& name) {
  const std::size_t area = svg.rfind("<rect", svg.find("fill=\"none\" stroke=\"#222\""));
  return std::stod(svg.substr(svg.find(" " + name + "=\"", area) + name.size() + 3));
}

TEST(Plot, WithEqualScalesASquareIsASquare) {
  const PlotSeries square{.x = {0, 4, 4, 0, 0}, .y = {0, 0, 4, 4, 0}, .mark = Mark::path};
  const Plot plot{.x = {.low = 0.0, .high = 8.0},
                  .y = {.low = 0.0, .high = 4.0},
                  .series = {square},
                  .equal_scales = true};
  const std::string svg = svg_of(plot);
  EXPECT_TRUE(is_well_formed(svg)) << svg;
  EXPECT_NEAR(attribute_of_area(svg, "width"), 2 * attribute_of_area(svg, "height"), 0.2);  // [px]
}

TEST(Plot, WithEqualScalesAHighPictureEndsInTime) {
  const PlotSeries way{.x = {0, 1}, .y = {0, 100}, .mark = Mark::path};
  const std::string svg = svg_of(Plot{.series = {way}, .equal_scales = true});
  EXPECT_LE(attribute_of_area(svg, "height"), 440.0);
}

TEST(Plot, ACloudIsOnePath) {
  PlotSeries cloud{.name = "cloud", .mark = Mark::dots};
  for (int i = 0; i < 50; ++i) {
    cloud.x.push_back(i % 7);
    cloud.y.push_back(i % 5);
  }
  const std::string svg = svg_of(Plot{.series = {cloud}});
  EXPECT_TRUE(is_well_formed(svg)) << svg;
  EXPECT_EQ(count(svg, "h0"), 50u + 3u) << "and three dots in the legend";
}

}  // namespace
}  // namespace mapbed
