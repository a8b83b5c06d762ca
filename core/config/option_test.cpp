#include "core/config/option.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/config/config_node.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

TEST(Bounds, WithoutAnEndGetTheLargestValueOfTheUnit) {
  const Bounds lengths = finite_bounds(Unit::meter, kPositive);
  EXPECT_EQ(lengths.low, 0.0);
  EXPECT_FALSE(lengths.low_itself);
  EXPECT_EQ(lengths.high, 1e4);
  EXPECT_EQ(finite_bounds(Unit::meter, kAnyValue).low, -1e4);
  EXPECT_EQ(finite_bounds(Unit::radian, between(-1.0, 2.0)).high, 2.0);
  for (int unit = 0; unit <= static_cast<int>(Unit::newton); ++unit) {
    const Bounds bounds = finite_bounds(static_cast<Unit>(unit), kAnyValue);
    EXPECT_TRUE(std::isfinite(bounds.low) && bounds.low < 0.0) << unit;
    EXPECT_TRUE(std::isfinite(bounds.high) && bounds.high > 0.0) << unit;
  }
}

TEST(Bounds, HoldForEveryNumberOfAFile) {
  const ConfigNode file = parse_config("{wall: 100 km, path: [1 m, -1e300 m]}", {"x.yaml", 1});
  EXPECT_INPUT_ERROR(file.at("wall").number(Unit::meter),
                     "x.yaml:1: '100 km' is too large; it must be at least -10000 m and at most "
                     "10000 m");
  EXPECT_INPUT_ERROR(file.at("path").numbers(Unit::meter), "'-1e300 m' is too small");
}

TEST(Bounds, LetASeedBeAnyNumber) {
  EXPECT_EQ(ConfigNode("18446744073709551615", {}).unsigned_number(), 18446744073709551615u);
}

}  // namespace
}  // namespace mapbed
