// A result's config.yaml is a scenario that gives the same result again.

#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "bench/results/figures.h"
#include "bench/results/judge.h"
#include "bench/results/result_folder.h"
#include "bench/scenario/identity.h"
#include "bench/scenario/scenario_log.h"
#include "bench/scenario/testing/own_files.h"
#include "core/file/text_file.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

class RunAgain : public OwnFiles, public ::testing::WithParamInterface<const char*> {};

TEST_P(RunAgain, GivesTheSameBytesFromItsOwnConfiguration) {
  run(planned(scenario(GetParam())), "first");
  // From another folder, into another one.
  std::filesystem::create_directories(path("copies/of"));
  std::filesystem::copy_file(path("first/config.yaml"), path("copies/of/config.yaml"));
  run(planned(path("copies/of/config.yaml")), "elsewhere/second");
  EXPECT_EQ(bytes_of("first"), bytes_of("elsewhere/second"));
  EXPECT_GT(bytes_of("first").size(), 8u);

  // Judged and drawn again, as a report does.
  Results results = load_results(path("first"));
  EXPECT_EQ(results.claims.size(), 1u);
  EXPECT_TRUE(judge_again(results));
  write_results(path("first"), results);
  write_figures(path("first"), results);
  EXPECT_EQ(bytes_of("first"), bytes_of("elsewhere/second"));
}

INSTANTIATE_TEST_SUITE_P(Worlds, RunAgain,
                         ::testing::Values("room.yaml", "planned.yaml", "workshop", "started.yaml",
                                           "corridor"));

class ConfigFile : public OwnFiles {
 protected:
  // As if it had been written by a program with another default.
  std::string with(const std::string& old_text, const std::string& new_text) const {
    std::string config = planned(scenario("corridor")).results.config_yaml;
    const std::size_t at = config.find(old_text);
    EXPECT_NE(at, std::string::npos) << old_text;
    config.replace(at, old_text.size(), new_text);
    return write("config.yaml", config);
  }
};

TEST_F(ConfigFile, IsReadBackAsItWasWritten) {
  const ScenarioPlan plan = planned(scenario("room.yaml"), {"seeds=1", "recorder.longest=2 s"});
  const ScenarioPlan again = planned(write("config.yaml", plan.results.config_yaml));
  EXPECT_EQ(again.results.config_yaml, plan.results.config_yaml);
  EXPECT_EQ(identity_of(again), identity_of(plan));
  EXPECT_THAT(plan.results.config_yaml, HasSubstr("recorder.longest: 2 s\n"));
}

TEST_F(ConfigFile, OfAQuickRunIsNotMadeLessAgain) {
  scenario("corridor", "quick: {seeds: 1, levels: 1, set: {recorder.longest: 0.5 s}}\n");
  const ScenarioPlan plan = make_plan(load_scenario(path("x.yaml"), {.quick = true}));
  const ScenarioPlan again = planned(write("config.yaml", plan.results.config_yaml));
  EXPECT_EQ(again.results.config_yaml, plan.results.config_yaml);
  EXPECT_TRUE(again.scenario.quick);
  EXPECT_FALSE(again.results.judges);
}

TEST_F(ConfigFile, HoldsAgainstDefaultsThatChanged) {
  const std::string config = with("success_distance: 1 m", "success_distance: 3 m");
  EXPECT_THAT(planned(config).results.config_yaml, HasSubstr("success_distance: 3 m"));
}

TEST_F(ConfigFile, SaysNothingOfAnotherWorld) {
  const std::string config = with("about: our own files", "about: our own files");
  EXPECT_EQ(planned(config, {"world=office"}).results.runs.size(), 0u);
  EXPECT_EQ(planned(config, {"people=3", "path=there_and_back"}).results.runs.size(), 0u);
}

TEST_F(ConfigFile, IsSimulatedToo) {
  const std::string level = "robot.odometry.distance_per_meter=5 cm";
  const ScenarioPlan plan = planned(scenario("room.yaml"));
  const std::string config = write("config.yaml", plan.results.config_yaml);
  const ScenarioChoice choice{.settings = {parse_setting(level)}};
  EXPECT_EQ(simulation_in(load_scenario(config, choice)).config,
            simulation_in(load_scenario(path("x.yaml"), choice)).config);
}

std::string compared(int variants) {
  std::string compare = "compare:\n";
  for (int i = 0; i < variants; ++i) {
    compare += fmt::format("  v{}: {{estimator: rbpf, rbpf.particles: {}}}\n", i, i + 1);
  }
  return "world: corridor\nrobot: ours.yaml\nmetrics: [path_length]\n" + compare;
}

TEST_F(ConfigFile, OfManyVariantsIsReadBackOrRefusedBeforeARun) {
  const ScenarioPlan plan = planned(write("y.yaml", compared(120)));
  const ScenarioPlan again = planned(write("config.yaml", plan.results.config_yaml));
  EXPECT_EQ(again.results.config_yaml, plan.results.config_yaml);
  EXPECT_INPUT_ERROR(planned(write("y.yaml", compared(900))),
                     "y.yaml: the complete configuration of 900 variants has ");
}

TEST_F(ConfigFile, OfAnOlderProgramIsRefusedInWords) {
  write("config.yaml", "scenario: {id: x}\nruns: {all: {experiment: {longest: 0 s}}}\n");
  EXPECT_INPUT_ERROR(planned(path("config.yaml")),
                     "config.yaml: was written by an older program, which cannot be run");
}

TEST_F(ConfigFile, OfALogRunsAgain) {
  write_log("drive.log");
  const std::string scenario =
      write("y.yaml",
            "log: drive.log\nlog.longest: 0.8 s\nestimator: scan_matching\n"
            "metrics: [path_length, largest_error]\n");
  run(planned(scenario), "first");
  run(planned(path("first/config.yaml")), "second");
  EXPECT_EQ(bytes_of("first"), bytes_of("second"));
}

}  // namespace
}  // namespace mapbed
