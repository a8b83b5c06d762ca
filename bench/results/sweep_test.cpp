#include "bench/results/sweep.h"

#include <gmock/gmock.h>

#include "core/config/config_node.h"
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

SweepAxis places() {
  return named_axis_of("place", parse_config("hall: {world: museum}\n"
                                             "maze: {world: office, crowd: {people: 3}}\n"
                                             "nothing: {}\n",
                                             {"x.yaml", 7}));
}

TEST(Sweep, NamesStandForSeveralSettings) {
  const SweepAxis axis = places();
  EXPECT_THAT(axis.texts, ElementsAre("hall", "maze", "nothing"));
  EXPECT_THAT(axis.numbers, IsEmpty());
  const Settings maze = settings_at(axis, 1);
  ASSERT_EQ(maze.size(), 2u);
  EXPECT_EQ(maze[1].path, "crowd.people");
  EXPECT_EQ(maze[1].text, "3");
  EXPECT_THAT(settings_at(axis, 2), IsEmpty());
  const Settings value = settings_at(axis_of("x", {"2 cm", "5 cm"}), 1);
  ASSERT_EQ(value.size(), 1u);
  EXPECT_EQ(value[0].path, "x");
  EXPECT_EQ(value[0].text, "5 cm");
}

TEST(Sweep, NamesThatAreNumbersTieOptionsAndHaveAPlaceAlongX) {
  const SweepAxis axis =
      named_axis_of("noise", parse_config("1 cm: {front.sigma: 1 cm, rear.sigma: 1 cm}\n"
                                          "5 cm: {front.sigma: 5 cm, rear.sigma: 5 cm}\n",
                                          {"x.yaml", 1}));
  EXPECT_THAT(axis.numbers, ElementsAre(1.0, 5.0));
  EXPECT_EQ(axis.unit, "cm");
  EXPECT_EQ(settings_at(axis, 1).at(1).text, "5 cm");
  const SweepAxis one = with_values(axis, {"5 cm"}, {"--set", 0});
  EXPECT_THAT(one.numbers, ElementsAre(5.0));
  EXPECT_EQ(settings_at(one, 0).at(0).path, "front.sigma");
}

TEST(Sweep, NamesAreWrittenAsTheyAreRead) {
  const std::string text = names_text(places());
  EXPECT_EQ(text, "{hall: {world: museum}, maze: {world: office, crowd.people: 3}, nothing: {}}");
  EXPECT_EQ(names_text(named_axis_of("place", parse_config(text, {"x.yaml", 1}))), text);
}

TEST(Sweep, SomeOfTheValuesKeepWhatTheyStandFor) {
  const SweepAxis some = with_values(places(), {"nothing", "maze"}, {"--set", 0});
  EXPECT_THAT(some.texts, ElementsAre("nothing", "maze"));
  EXPECT_EQ(settings_at(some, 1)[0].text, "office");
  EXPECT_INPUT_ERROR(with_values(places(), {"haul"}, {"--set", 0}),
                     "'haul' is no value of the sweep of 'place'; did you mean 'hall'?");
  EXPECT_THAT(with_values(axis_of("x", {"2 cm"}), {"7 cm"}, {}).numbers, ElementsAre(7.0));
}

TEST(Sweep, APathIsReadAsWords) {
  EXPECT_EQ(words_of("robot.odometry.rotation_sigma"), "rotation sigma");
  EXPECT_EQ(words_of("translation_error"), "translation error");
}

}  // namespace
}  // namespace mapbed
