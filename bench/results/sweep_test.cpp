#include "bench/results/sweep.h"

#include <gmock/gmock.h>

#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Sweep, AnAxisKnowsItsNumbersAndUnit) {
  const SweepAxis lengths = axis_of("x", {"2 cm", "5 cm"});
  EXPECT_EQ(lengths.unit, "cm");
  EXPECT_THAT(lengths.numbers, ElementsAre(2.0, 5.0));
  EXPECT_TRUE(axis_of("x", {"2 cm", "5 m"}).numbers.empty());
  EXPECT_TRUE(axis_of("x", {"left", "right"}).numbers.empty());
}

TEST(Sweep, LevelsCountTheLastAxisFastest) {
  const std::vector<Level> levels =
      levels_of({axis_of("a", {"1", "2"}), axis_of("b", {"x", "y", "z"})});
  ASSERT_EQ(levels.size(), 6u);
  EXPECT_THAT(levels[1].choice, ElementsAre(0, 1));
  EXPECT_THAT(levels[3].choice, ElementsAre(1, 0));
  ASSERT_EQ(levels_of({}).size(), 1u);
  EXPECT_THAT(levels_of({})[0].choice, IsEmpty());
}

TEST(Sweep, RefusesMoreLevelsThanAnybodyCanRun) {
  const std::vector<SweepAxis> axes(20, axis_of("a", {"1", "2", "3"}));  // 3^20
  EXPECT_INPUT_ERROR(levels_of(axes), "the sweep has 3.49e+09 levels, of 1e+06 at most");
}

TEST(Sweep, APathIsReadAsWords) {
  EXPECT_EQ(words_of("robot.odometry.rotation_sigma"), "rotation sigma");
  EXPECT_EQ(words_of("translation_error"), "translation error");
}

}  // namespace
}  // namespace mapbed
