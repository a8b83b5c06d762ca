#include "bench/scenario/scenario.h"

#include <fstream>

#include <gmock/gmock.h>

#include "bench/scenario/identity.h"
#include "bench/scenario/plan.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;

class ScenarioFile : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& yaml) const {
    std::ofstream(folder_.file(name)) << yaml;
    return folder_.file(name);
  }
  ScenarioPlan plan(const std::string& yaml, const ScenarioChoice& choice = {}) const {
    return make_plan(load_scenario(write("x.yaml", yaml), choice));
  }

  TemporaryFolder folder_;
};

constexpr const char* kCells =
    "experiment: odds_vs_counting\n"
    "sweep: {hits: [1, 2, 4], misses: [0, 3]}\n"
    "compare: {a: {model: counting}, b: {model: odds}}\n"
    "metrics: [occupancy]\n";

TEST_F(ScenarioFile, RunsEveryLevelVariantAndSeed) {
  const ScenarioPlan plan = this->plan(kCells + std::string("seeds: 5\nseed: 3\n"));
  EXPECT_EQ(plan.runs(), 3 * 2 * 2 * 5);
  const RunRow last = plan.row(plan.runs() - 1);
  EXPECT_EQ(last.seed, 7u);
  EXPECT_EQ(level_text(plan.results, last.level), "hits = 4, misses = 3");
  EXPECT_EQ(plan.results.variants[static_cast<std::size_t>(last.variant)], "b");
}

TEST_F(ScenarioFile, QuickKeepsTheEndsOfEachAxis) {
  const ScenarioPlan plan =
      this->plan(kCells + std::string("seeds: 5\nquick: {seeds: 2, levels: 2}\n"), {.quick = true});
  EXPECT_THAT(plan.results.axes[0].texts, ElementsAre("1", "4"));
  EXPECT_EQ(plan.runs(), 2 * 2 * 2 * 2);
}

TEST_F(ScenarioFile, AQuickRunJudgesWithAsManySeedsAndNoOtherSettingsOrWhereItSaysSo) {
  const auto judges = [&](const std::string& quick) {
    const ScenarioPlan plan =
        this->plan(kCells + std::string("seeds: 5\n") + quick, {.quick = true});
    return plan.results.judges;
  };
  EXPECT_FALSE(judges(""));  // one seed
  EXPECT_TRUE(judges("quick: {seeds: 5, levels: 2}\n"));
  EXPECT_FALSE(judges("quick: {seeds: 4}\n"));
  EXPECT_FALSE(judges("quick: {seeds: 5, set: {odds.p_occ: 0.7}}\n"));
  EXPECT_TRUE(judges("quick: {seeds: 5, set: {odds.p_occ: 0.7}, judges: true}\n"));
  EXPECT_FALSE(judges("quick: {seeds: 5, judges: false}\n"));
  EXPECT_TRUE(plan(kCells).results.judges);
}

constexpr const char* kNamed =
    "experiment: odds_vs_counting\n"
    "sweep: {look: {never: {hits: 0}, often: {hits: 70, misses: 30}, once: {hits: 1}}}\n"
    "compare: {a: {model: counting}, b: {model: odds}}\n"
    "metrics: [occupancy]\n";

TEST_F(ScenarioFile, SweepsSeveralOptionsTogetherByNames) {
  const ScenarioPlan plan = this->plan(kNamed);
  ASSERT_EQ(plan.planned.size(), 6u);
  EXPECT_EQ(level_text(plan.results, 1), "look = often");
  const std::string& often = plan.planned[2].experiment.complete_yaml;
  EXPECT_THAT(often, ::testing::HasSubstr("hits: 70"));
  EXPECT_THAT(often, ::testing::HasSubstr("misses: 30"));
  EXPECT_EQ(this->plan(kNamed, {.settings = {parse_setting("look=[once, never]")}}).runs(), 4);
  EXPECT_INPUT_ERROR(this->plan(kNamed, {.settings = {parse_setting("look=oftn")}}),
                     "did you mean 'often'?");
}

TEST_F(ScenarioFile, OfNamesRunsAgainFromItsConfiguration) {
  const ScenarioPlan plan = this->plan(kNamed);
  const ScenarioPlan again = make_plan(load_scenario(write("y.yaml", plan.results.config_yaml)));
  EXPECT_EQ(again.runs(), plan.runs());
  EXPECT_EQ(again.planned[2].experiment.complete_yaml, plan.planned[2].experiment.complete_yaml);
  EXPECT_EQ(identity_of(again), identity_of(plan));
}

TEST_F(ScenarioFile, QuickTakesAsManyLevelsOfEachAxisAsItSays) {
  const ScenarioPlan plan =
      this->plan(kCells + std::string("quick: {levels: {hits: 1, misses: 2}}\n"), {.quick = true});
  EXPECT_THAT(plan.results.axes[0].texts, ElementsAre("1"));
  EXPECT_THAT(plan.results.axes[1].texts, ElementsAre("0", "3"));
}

TEST_F(ScenarioFile, AVariantMayHaveFewerSeeds) {
  const std::string yaml =
      "experiment: odds_vs_counting\nseeds: 3\nmetrics: [occupancy]\n"
      "compare: {a: {model: counting, seeds: 1}, b: {model: odds}}\n";
  const ScenarioPlan plan = this->plan(yaml);
  EXPECT_THAT(plan.runs_to_do(), ElementsAre(0, 1, 3, 5));
  const ScenarioPlan again = make_plan(load_scenario(write("y.yaml", plan.results.config_yaml)));
  EXPECT_THAT(again.runs_to_do(), ElementsAre(0, 1, 3, 5));
  EXPECT_EQ(identity_of(again), identity_of(plan));
  const ScenarioPlan all = this->plan(
      "experiment: odds_vs_counting\nseeds: 3\nmetrics: [occupancy]\n"
      "compare: {a: {model: counting}, b: {model: odds}}\n");
  EXPECT_NE(identity_of(all), identity_of(plan));
  EXPECT_THAT(this->plan(yaml, {.settings = {parse_setting("seeds=1")}}).runs_to_do(),
              ElementsAre(0, 1));
  EXPECT_INPUT_ERROR(
      this->plan("experiment: odds_vs_counting\nmetrics: [occupancy]\ncompare: {a: {seeds: 0}}\n"),
      "'0' is too small");
}

TEST_F(ScenarioFile, SetFromTheCommandLineHasTheLastWord) {
  const ScenarioChoice choice{.settings = {parse_setting("hits=[7, 8]"), parse_setting("seeds=4"),
                                           parse_setting("odds.p_occ=0.9")}};
  const ScenarioPlan plan = this->plan(kCells + std::string("odds.p_occ: 0.7\n"), choice);
  EXPECT_THAT(plan.results.axes[0].texts, ElementsAre("7", "8"));
  EXPECT_EQ(plan.scenario.seeds, 4);
  EXPECT_THAT(plan.results.config_yaml, ::testing::HasSubstr("p_occ: 0.9"));
}

TEST_F(ScenarioFile, ABaseIsReadFirst) {
  write("base.yaml", kCells + std::string("seeds: 5\nmisses: 1\n"));
  const ScenarioPlan plan = this->plan("base: base.yaml\nseeds: 2\nsweep: {hits: [9]}\n");
  EXPECT_EQ(plan.runs(), 1 * 2 * 2);
  EXPECT_THAT(plan.results.config_yaml, ::testing::HasSubstr("misses: 1"));
}

TEST_F(ScenarioFile, IsRefusedWithPlaceAndRemedy) {
  const auto refuse = [&](const std::string& more, const std::string& message) {
    EXPECT_INPUT_ERROR(plan(kCells + more), message);
  };
  refuse("seedz: 3\n", "x.yaml:5: unknown key 'seedz'; did you mean 'seeds'?");
  refuse("drivr: scripted\n", "x.yaml:5: unknown key 'drivr'; did you mean 'driver'?");
  refuse("odds.p_ock: 0.7\n", "x.yaml:5: unknown key 'p_ock' in odds_vs_counting.odds; did you");
  refuse("odds.p_occ: 7\n", "x.yaml:5: '7' is too large");
  refuse("seeds: 0\n", "'0' is too small");
  refuse("seeds: 50000\n", "this makes 600000 runs");
  refuse("world: office\n", "'world' says nothing to the experiment odds_vs_counting");
  refuse("claims: [{metric: occupance, at_most: 1}]\n", "did you mean 'occupancy'?");
  refuse("claims: [{metric: occupancy, of: c, at_most: 1}]\n", "'c' is not compared");
  refuse("claims: [{metric: occupancy, at_most: c}]\n", "'c' is neither a variant nor a number");
  refuse("claims: [{metric: occupancy}]\n", "compares with nothing");
  refuse("claims: [{metric: occupancy, equals: 1}]\n", "nothing about how exact");
  refuse("claims: [{metric: occupancy, above: 0, at: {hits: 3}}]\n", "has no value '3'");
  refuse("plots: [{x: hitz, y: occupancy}]\n", "did you mean 'hits'?");
  EXPECT_INPUT_ERROR(
      plan("experiment: odds_vs_count\nmetrics: [a]\n"),
      "x.yaml:1: unknown experiment 'odds_vs_count'; did you mean 'odds_vs_counting'?");
  EXPECT_INPUT_ERROR(plan("experiment: odds_vs_counting\nmetrics: [ocupancy]\n"),
                     "x.yaml:2: unknown metric 'ocupancy' of experiment odds_vs_counting; did you "
                     "mean 'occupancy'?");
  EXPECT_INPUT_ERROR(plan("about: a\nestimator: scan_maching\nmetrics: [success]\n"),
                     "x.yaml:2: unknown method 'scan_maching'; did you mean 'scan_matching'?");
  EXPECT_INPUT_ERROR(
      plan("experiment: odds_vs_counting\nmetrics: [occupancy]\nsweep:\n  hits: [1, -1]\n"),
      "x.yaml:4: '-1' is too small");
  EXPECT_INPUT_ERROR(plan("experiment: odds_vs_counting\nsweep: {hits: []}\nmetrics: [occupancy]"),
                     "the sweep of 'hits' has no values");
  EXPECT_INPUT_ERROR(plan("experiment: odds_vs_counting\n"), "nothing is measured");
  EXPECT_INPUT_ERROR(plan("metrics: [success]\n"), "there is no log to work on");
  EXPECT_INPUT_ERROR(plan("base: x.yaml\n"), "build on each other without end");
}

}  // namespace
}  // namespace mapbed
