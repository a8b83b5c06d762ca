#include "bench/scenario/staging_folder.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include "core/file/text_file.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

Results two_variants(const std::string& first, const std::string& second) {
  Results plan{.id = "plan"};
  plan.levels = levels_of({});
  plan.variants = {first, second};
  plan.metrics = {{"success", Unit::none, ""}};
  plan.series_metrics = {{"residual", Unit::meter, "iteration", Unit::none, ""}};
  plan.plots = {{.file = "success", .y = "success"}};
  return plan;
}

RunResult run(int number, const std::string& file = "maps/map.png") {
  return {.row = {.run = number, .variant = number % 2, .seed = 1, .values = {1.0}},
          .cost = {.run = number},
          .files = {{file, "a map"}},
          .series = {{"residual", {{0, 0.5}}, number}}};
}

class Staging : public ::testing::Test {
 protected:
  StagingFolder opened(const std::string& identity = "this", bool afresh = false) const {
    return {folder_.file(""), plan_, identity, afresh};
  }
  std::string path(const std::string& name) const { return folder_.file("runs/" + name); }

  TemporaryFolder folder_;
  Results plan_ = two_variants("raw", "matched");
};

TEST_F(Staging, AFileOfSomebodyElseIsNotTakenAway) {
  fs::create_directory(folder_.file("maps"));
  std::ofstream(folder_.file("maps/map_raw.png")) << "drawn by hand";
  StagingFolder staging = opened();
  EXPECT_INPUT_ERROR(staging.commit(run(0)), "maps/map_raw.png: was not written by mapbed");
  EXPECT_NO_THROW(staging.commit(run(1)));
}

TEST_F(Staging, GivesBackRunsWithAllThatTheyGave) {
  {
    StagingFolder staging = opened();
    staging.commit(run(0));
    staging.commit(run(1));
  }
  const StagingFolder staging = opened();
  ASSERT_EQ(staging.found().size(), 2u);
  Results results = plan_;
  results.runs = {run(0).row, run(1).row};
  staging.collect(results);
  EXPECT_EQ(results.series.size(), 2u);
  ASSERT_EQ(results.files.size(), 2u);
  EXPECT_EQ(results.files[1].path, "maps/map_matched.png");
}

// As after a power cut that the journal has survived and they have not.
TEST_F(Staging, ARunWhoseFilesAreNotAsWrittenIsDoneAgain) {
  for (const char* lost : {"files/maps/map_raw.png", "tables/series_0.csv", "tables/files_0.csv"}) {
    SCOPED_TRACE(lost);
    {
      StagingFolder staging = opened("this", true);
      staging.commit(run(0));
      staging.commit(run(1));
    }
    fs::resize_file(path(lost), 0);
    StagingFolder staging = opened();
    ASSERT_EQ(staging.found().size(), 1u);
    EXPECT_EQ(staging.found()[0].row.run, 1);
    staging.commit(run(0));
    EXPECT_EQ(opened().found().size(), 3u) << "the line of before counts again, too";
  }
}

// Killed while the runs of before were thrown away.
TEST_F(Staging, WhatIsLeftOfAnotherConfigurationDoesNotCount) {
  { opened("other").commit(run(1)); }
  std::ofstream(path("journal")) << "torn";
  StagingFolder staging = opened("this");
  RunResult without_series = run(1);
  without_series.series.clear();
  staging.commit(without_series);
  Results results = plan_;
  results.runs = {run(1).row};
  staging.collect(results);
  EXPECT_TRUE(results.series.empty());
}

TEST_F(Staging, AFolderOfSomebodyElseIsLeftAlone) {
  fs::create_directories(path("files"));
  std::ofstream(path("files/own.txt")) << "x";
  EXPECT_INPUT_ERROR(opened("this", true), "is in the way: it holds no unfinished runs");
  discard_staging(folder_.file(""), "this");
  EXPECT_TRUE(fs::exists(path("files/own.txt")));
}

TEST_F(Staging, TheRunsOfAnotherConfigurationAreNotThrownAwayUnasked) {
  { opened("other").commit(run(0)); }
  EXPECT_INPUT_ERROR(opened("this"), "--restart throws them away");
  discard_staging(folder_.file(""), "this");
  EXPECT_EQ(opened("other").found().size(), 1u);
  discard_staging(folder_.file(""), "other");
  EXPECT_FALSE(fs::exists(path("")));
}

TEST_F(Staging, TakesOverTheRunsOfAnotherThatItHasNot) {
  const auto other = [this] {
    return StagingFolder{folder_.file(""), plan_, "this", false, "shards/1_of_2/runs"};
  };
  RunResult own = run(1);
  own.row.values = {0.25};
  opened().commit(own);
  {
    StagingFolder of_other = other();
    of_other.commit(run(0));
    of_other.commit(run(1));
  }
  opened().take_over(other());
  const StagingFolder staging = opened();
  ASSERT_EQ(staging.found().size(), 2u);
  EXPECT_EQ(staging.found()[0].row.values[0], 0.25) << "its own";
  EXPECT_EQ(staging.found()[1].row.run, 0);
  EXPECT_EQ(read_text_file(path("files/maps/map_raw.png")), "a map");
  EXPECT_EQ(other().found().size(), 2u) << "stays";
}

TEST_F(Staging, TwoFilesOfOneNameAreRefused) {
  StagingFolder staging = opened();
  staging.commit(run(0));
  EXPECT_INPUT_ERROR(staging.commit(run(2)),
                     "maps/map_raw.png: would be the file of run 0 and of "
                     "run 2");
  plan_.variants = {"all"};
  EXPECT_INPUT_ERROR(
      staging.commit(run(4, "figures/success.svg")),
      "figures/success.svg: would be the file of a plot and of a run; give the plot");
}

}  // namespace
}  // namespace mapbed
