#include "bench/plot/heat_map.h"

#include <limits>

#include <gmock/gmock.h>

#include "bench/plot/testing/well_formed.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

HeatMap slope() {
  return {.title = "A slope",
          .x = {"x", "m"},
          .y = {"y", "m"},
          .value = {"height", "m"},
          .xs = {0, 1, 2},
          .ys = {0, 1},
          .values = {0, 1, 2, 0, 1, 2}};
}

TEST(HeatMap, IsWellFormedAndNamesItsScale) {
  const std::string svg = svg_of(slope());
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("height [m]"));
  EXPECT_THAT(svg, HasSubstr("data:image/png;base64,"));
  EXPECT_THAT(svg, Not(HasSubstr("no value")));
}

TEST(HeatMap, HatchesWhatHasNoValueAndSaysSo) {
  HeatMap map = slope();
  map.values[2] = kNaN;
  EXPECT_THAT(svg_of(map), HasSubstr("no value"));
  map.values.assign(6, kNaN);
  EXPECT_TRUE(is_well_formed(svg_of(map)));
  map.values.assign(6, 3.0);
  EXPECT_TRUE(is_well_formed(svg_of(map))) << "a plane";
}

TEST(HeatMap, ContoursOfASlopeAreStraight) {
  // Height is x: the line of 1 m is upright in the middle of the area, as is that of x = 1.
  HeatMap map = slope();
  map.values = {0.0, 1.0, 2.0, 0.0, 1.0, 2.0};
  const std::string with = svg_of(map);
  map.contours = false;
  const std::string without = svg_of(map);
  EXPECT_THAT(with, HasSubstr("stroke-opacity=\"0.6\""));
  EXPECT_THAT(without, Not(HasSubstr("stroke-opacity=\"0.6\"")));
}

TEST(HeatMap, ItsTableHasEveryNumber) {
  HeatMap map = slope();
  map.values[5] = kNaN;
  EXPECT_EQ(csv_of(map), "x [m],y [m],height [m]\n0,0,0\n1,0,1\n2,0,2\n0,1,0\n1,1,1\n2,1,\n");
}

}  // namespace
}  // namespace mapbed
