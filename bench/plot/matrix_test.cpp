#include "bench/plot/matrix.h"

#include <limits>

#include <gmock/gmock.h>

#include "bench/plot/testing/well_formed.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Matrix two_by_three() {
  return {.title = "What breaks what",
          .rows_label = "fault",
          .rows = {"stall 1 s", "drift <5>"},
          .columns = {{"near", "a"}, {"near", "b"}, {"far", "a"}},
          .value = {.label = "ratio", .logarithmic = true, .low = 1.0, .high = 100.0},
          .values = {1, 10, 100, 1000, kNaN, 0.5},
          .marks = {0, 1, 0.4, 0, 0, 1},
          .mark_label = "told"};
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(Matrix, NamesRowsColumnsAndGroupsOnce) {
  const std::string svg = svg_of(two_by_three());
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr(">stall 1 s</text>"));
  EXPECT_THAT(svg, HasSubstr(">drift &lt;5&gt;</text>"));
  EXPECT_EQ(count_of(svg, ">near</text>"), 1U);
  EXPECT_EQ(count_of(svg, ">far</text>"), 1U);
  EXPECT_EQ(count_of(svg, ">a</text>"), 2U);
  EXPECT_THAT(svg, HasSubstr(">ratio</text>"));
}

TEST(Matrix, HasADotWhereTheMarkIsAboveAHalfAndOneInTheLegend) {
  EXPECT_EQ(count_of(svg_of(two_by_three()), "<circle"), 3U);
  Matrix without = two_by_three();
  without.marks.clear();
  EXPECT_EQ(count_of(svg_of(without), "<circle"), 0U);
}

TEST(Matrix, CrossesOutWhatHasNoValueAndSaysSo) {
  EXPECT_THAT(svg_of(two_by_three()), HasSubstr(">no value</text>"));
  Matrix whole = two_by_three();
  whole.values[4] = 2.0;
  EXPECT_THAT(svg_of(whole), Not(HasSubstr("no value")));
}

// 1000 looks like 100, 0.5 like 1: three colours in six cells, and 60 in the scale.
TEST(Matrix, ValuesBeyondTheEndsHaveTheColourOfTheEnd) {
  const auto color_after = [](const std::string& svg, const std::string& title) {
    const std::size_t fill = svg.find("fill=\"#", svg.find(title));
    return svg.substr(fill, 14);
  };
  const std::string svg = svg_of(two_by_three());
  EXPECT_EQ(color_after(svg, "far, a: 100"), color_after(svg, "near, a: 1000"));
  EXPECT_EQ(color_after(svg, "near, a: 1<"), color_after(svg, "far, a: 0.5"));
  EXPECT_NE(color_after(svg, "near, a: 1<"), color_after(svg, "near, b: 10, told"));
}

TEST(Matrix, ItsTableHasEveryNumber) {
  EXPECT_EQ(csv_of(two_by_three()),
            "fault,group,column,ratio,told\n"
            "stall 1 s,near,a,1,0\nstall 1 s,near,b,10,1\nstall 1 s,far,a,100,0.4\n"
            "drift <5>,near,a,1000,0\ndrift <5>,near,b,,0\ndrift <5>,far,a,0.5,1\n");
}

}  // namespace
}  // namespace mapbed
