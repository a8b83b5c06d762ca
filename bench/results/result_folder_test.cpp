#include "bench/results/result_folder.h"

#include <chrono>
#include <filesystem>
#include <limits>
#include <map>
#include <sstream>

#include <gmock/gmock.h>

#include "bench/results/plan_yaml.h"
#include "bench/results/result_tables.h"
#include "bench/results/summary.h"
#include "core/file/hash.h"
#include "core/file/text_file.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string config_of(const Results& plan) {
  std::istringstream lines(plan_yaml(plan));
  std::string text = "scenario:\n";
  for (std::string line; std::getline(lines, line);) text += "  " + line + "\n";
  return text + "runs: {}\n";
}

Claim claim(const std::string& yaml) {
  return claim_of(parse_config(yaml, {"x.yaml", 1}));
}

// One run of nothing but a number.
Results plain() {
  Results r{.id = "plain", .experiment = "slam"};
  r.levels = levels_of({});
  r.variants = {"all"};
  r.metrics = {{"success", Unit::none, ""}};
  r.config_yaml = config_of(r);
  r.runs = {{.run = 0, .seed = 1, .values = {1.0}}};
  r.summary = summary_of(r);
  r.costs = {{.run = 0, .seconds = 0.5}};
  return r;
}

// With everything that a result can have, and names that are hard to write.
Results rich() {
  Results r{.id = "rich",
            .about = "Is it \"a, b: c\"?",
            .thesis = "Figure 3.10",
            .experiment = "slam",
            .quick = true,
            .seed = 18446744073709551615u,
            .seeds = 2};
  r.axes = {axis_of("robot.odometry.rotation_sigma", {"0 deg", "2 deg"}),
            axis_of("world", {"a, b", "it's # 1"})};
  r.levels = levels_of(r.axes);
  r.variants = {"raw", "matched, \"twice\""};
  r.metrics = {{"heading_error", Unit::radian, "ATE: RMS turn"}, {"success", Unit::none, ""}};
  r.series_metrics = {{"residual", Unit::meter, "iteration", Unit::none, "after each step"},
                      {"turn", Unit::radian, "time", Unit::second, ""}};
  r.plots = {{.file = "error", .title = "a: b", .x = "world", .y = "heading_error"},
             {.file = "residual", .kind = PlotKind::series, .y = "residual", .log_y = true}};
  r.claims = {claim("{metric: heading_error, of: raw, equals: 2 deg, within: 1e-3 deg, at: {robot."
                    "odometry.rotation_sigma: 2 deg}, statistic: median, thesis: 'yes, 2 deg'}"),
              claim("{series: residual, take: last, of: raw, below: 1 cm, at: upper half}"),
              claim("{series: turn, of: raw, above: 'matched, \"twice\"', times: 0.1, "
                    "test: sign, at: {time: 10 s, world: 'a, b'}}"),
              claim("{metric: run_seconds, at_most: 3 s}")};
  r.skipped = {"the log 'x' is not here: 2 runs skipped"};
  r.config_yaml = config_of(r);
  r.runs = {{.run = 0, .seed = r.seed, .values = {0.1, 1.0 / 3.0}},
            {.run = 5,
             .level = 2,
             .variant = 1,
             .seed = r.seed,
             .values = {kNone, 0.0},
             .failure = "lost, at \"3 s\""}};
  r.summary = summary_of(r);
  r.series = {{"residual", {{0, 0.5}, {1, 0.1}}, 0}, {"turn", {{0.1, 1e-300}}, 0}};
  r.verdicts = {{.claim = "a", .held = true, .measured = "1 against 2", .thesis = "so"},
                {.claim = "b", .measured = "3, 4"},
                {.claim = "c", .judged = false, .measured = "no such level"},
                {.claim = "d", .held = true, .measured = "1 s", .of_cost = true}};
  r.costs = {{0, 1.5, 0.25, 1.0, 60.0, 123456789.0, 2.5, 1e6}, {5, 0.0, 0.0, 0.0, 0.0, 0.0}};
  r.files = {{"maps/map_level_0_raw.png", 0, "map"}, {"learned/a_level_2_x.yaml", 5, ""}};
  r.provenance_json = "{\"seed\": 7}\n";
  return r;
}

class ResultFolder : public ::testing::Test {
 protected:
  // By path, as they stand in the folder.
  std::map<std::string, std::string> files_in(const std::string& folder) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.file(folder))) {
      files[entry.path().filename()] = read_text_file(entry.path());
    }
    return files;
  }
  void write(const std::string& folder, const Results& results) const {
    std::filesystem::create_directories(folder_.file(folder));
    write_results(folder_.file(folder), results);
  }
  TemporaryFolder folder_;
};

TEST_F(ResultFolder, IsWrittenAsItWasRead) {
  for (const Results& results : {plain(), rich()}) {
    SCOPED_TRACE(results.id);
    write("once", results);
    const Results read = load_results(folder_.file("once"));
    write("twice", read);
    EXPECT_EQ(files_in("twice"), files_in("once"));
    EXPECT_EQ(config_of(read), results.config_yaml) << "the plan alone, too";
  }
}

TEST_F(ResultFolder, HasAFileForWhatThereIsAlone) {
  write("rich", rich());
  EXPECT_EQ(files_in("rich").size(), 9u);
  write("plain", plain());
  std::vector<std::string> names;
  for (const auto& [name, content] : files_in("plain")) names.push_back(name);
  EXPECT_THAT(names,
              ElementsAre("claims.csv", "config.yaml", "cost.csv", "runs.csv", "summary.csv"));
}

TEST_F(ResultFolder, GivesBackRowsAndFiles) {
  write("rich", rich());
  const Results read = load_results(folder_.file("rich"));
  ASSERT_EQ(read.runs.size(), 2u);
  EXPECT_EQ(read.runs[1].failure, "lost, at \"3 s\"");
  EXPECT_EQ(read.runs[0].values[1], 1.0 / 3.0);
  ASSERT_EQ(read.series.size(), 2u);
  EXPECT_EQ(read.series[0].points[1].value, 0.1);
  EXPECT_TRUE(read.series_metrics[1].x_unit == Unit::second);
  ASSERT_EQ(read.verdicts.size(), 4u);
  EXPECT_FALSE(read.verdicts[2].judged);
  EXPECT_TRUE(read.verdicts[3].of_cost);
  ASSERT_EQ(read.claims.size(), 4u);
  EXPECT_EQ(read.claims[2].times, 0.1);
  EXPECT_EQ(run_words(read, read.runs[1]), "rotation sigma 2 deg, world a, b, matched, \"twice\"");
  ASSERT_EQ(read.files.size(), 2u);
  EXPECT_EQ(read.files[0].title, "map");
}

TEST_F(ResultFolder, ConsistsOfTablesPlotsAndListedFiles) {
  EXPECT_THAT(paths_of_result(folder_.file("")), IsEmpty());
  write("r", rich());
  const std::vector<std::string> paths = paths_of_result(folder_.file("r"));
  for (const char* path : {"config.yaml", "runs.csv", "provenance.json", "report.html",
                           "figures/error.svg", "figures/error.csv", "maps/map_level_0_raw.png"}) {
    EXPECT_THAT(paths, ::testing::Contains(path));
  }
}

TEST_F(ResultFolder, WhatIsAsWrittenIsNotWrittenAgain) {
  write("r", rich());
  const std::string file = folder_.file("r/runs.csv");
  const auto long_ago = std::filesystem::last_write_time(file) - std::chrono::hours(1);
  std::filesystem::last_write_time(file, long_ago);
  write("r", rich());
  EXPECT_EQ(std::filesystem::last_write_time(file), long_ago);
}

TEST_F(ResultFolder, OfSomebodyElsesFilesIsRefused) {
  std::filesystem::create_directories(folder_.file("r"));
  const std::string folder = folder_.file("r");
  EXPECT_NO_THROW(refuse_foreign_files(folder, rich()));
  write("r", plain());
  EXPECT_NO_THROW(refuse_foreign_files(folder, rich()));
  write_text_file(folder + "/config.yaml", "mine: 1\n");
  EXPECT_INPUT_ERROR(refuse_foreign_files(folder, rich()),
                     "r/config.yaml: was not written by mapbed, and would be written over");
}

TEST_F(ResultFolder, OfAnotherScenarioMayHoldSomebodysPicturesAllTheSame) {
  const std::string folder = folder_.file("r");
  std::filesystem::create_directories(folder + "/figures");
  write_text_file(folder + "/figures/error.svg", "drawn by hand");
  EXPECT_NO_THROW(refuse_foreign_files(folder, plain())) << "which has no such plot";
  write("r", plain());
  EXPECT_INPUT_ERROR(refuse_foreign_files(folder, rich()),
                     "r/figures/error.svg: was not written by mapbed");
  std::filesystem::remove(folder + "/figures/error.svg");
  write("r", rich());
  std::filesystem::create_directories(folder + "/maps");
  for (const char* name : {"/maps/map_level_0_raw.png", "/maps/mine.png"}) {
    write_text_file(folder + name, "x");
  }
  EXPECT_FALSE(is_foreign(folder, "maps/map_level_0_raw.png")) << "is listed";
  EXPECT_TRUE(is_foreign(folder, "maps/mine.png"));
  EXPECT_FALSE(is_foreign(folder, "maps/none.png")) << "is not there";
}

TEST_F(ResultFolder, TablesThatWereChangedSinceAreRefused) {
  Results results = rich();
  results.provenance_json = "{\"tables_sha256\": {\"runs.csv\": \"" + sha256(runs_csv(results)) +
                            "\", \"files.csv\": \"" + sha256(files_csv(results)) + "\"}}\n";
  write("r", results);
  EXPECT_NO_THROW(load_results(folder_.file("r")));
  const std::string runs = read_text_file(folder_.file("r/runs.csv"));
  std::string better = runs;
  better.replace(better.find("0.1"), 3, "0.2");
  for (const std::string& changed : {runs.substr(0, runs.find('\n', runs.find('\n') + 1) + 1),
                                     runs + runs.substr(runs.find('\n') + 1), better}) {
    write_text_file(folder_.file("r/runs.csv"), changed);
    EXPECT_INPUT_ERROR(load_results(folder_.file("r")),
                       "runs.csv: is not the table that was written");
  }
  write_text_file(folder_.file("r/runs.csv"), runs);
  std::filesystem::remove(folder_.file("r/files.csv"));
  EXPECT_INPUT_ERROR(load_results(folder_.file("r")), "files.csv: is not the table");
}

// Before, claims were sentences and nothing listed the pictures.
TEST_F(ResultFolder, OfAnOlderProgramIsReadToo) {
  write("old", rich());
  const std::string config = folder_.file("old/config.yaml");
  std::string text = read_text_file(config);
  text = text.substr(0, text.find("  claims:")) + "  claims:\n    - \"it is, all: in all, so\"\n";
  write_text_file(config, text);
  std::filesystem::remove(folder_.file("old/files.csv"));
  std::filesystem::create_directories(folder_.file("old/maps"));
  write_text_file(folder_.file("old/maps/map_level_2_matched_twice.png"), "x");
  const Results read = load_results(folder_.file("old"));
  EXPECT_THAT(read.claims, IsEmpty());
  EXPECT_EQ(read.verdicts.size(), 4u);
  ASSERT_EQ(read.files.size(), 1u);
  EXPECT_EQ(read.files[0].run, 5);
  EXPECT_EQ(read.files[0].title, "map");
}

TEST_F(ResultFolder, IsRefusedWhereItIsDamaged) {
  const auto refuse = [&](const std::string& name, const std::string& content,
                          const std::string& message) {
    write("r", rich());
    write_text_file(folder_.file("r/" + name), content);
    EXPECT_INPUT_ERROR(load_results(folder_.file("r")), message);
  };
  refuse("runs.csv", "run,seed\n", "runs.csv:1: these are not the columns of this table");
  refuse("claims.csv", "claim,held,measured,thesis\na,yes\n", "claims.csv:2");
  refuse("series.csv", "run,series,x,value\n0,residuum,1,1\n",
         "series.csv:2: this row is not of this scenario");
  refuse("series.csv", "run,series,x,value\nzero,residual,1,1\n", "'zero' is not a whole number");
  refuse("cost.csv", "", "cost.csv: is empty");
  refuse("files.csv", "path\nmaps/a.png\n", "files.csv:1: has no column 'run'");
  for (const char* path : {"../a.png", "maps/../../a.png", "/etc/passwd"}) {
    refuse("files.csv", std::string("run,path,title\n0,") + path + ",a\n",
           "is no path below the result's folder");
  }
}

}  // namespace
}  // namespace mapbed
