#include "bench/scenario/publication.h"

#include <filesystem>

#include <gmock/gmock.h>

#include "bench/results/plan_yaml.h"
#include "bench/results/result_folder.h"
#include "bench/results/summary.h"
#include "core/config/settings.h"
#include "core/file/atomic_file.h"
#include "core/file/text_file.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

// One run with a plot and a map.
Results result(const std::string& id, const std::string& plot, const std::string& map) {
  Results r{.id = id, .experiment = "slam"};
  r.levels = levels_of({});
  r.variants = {"all"};
  r.metrics = {{"success", Unit::none, ""}};
  r.plots = {{.file = plot, .kind = PlotKind::bars, .y = "success"}};
  r.config_yaml = "scenario:\n" + indented(plan_yaml(r), 2);
  r.runs = {{.run = 0, .seed = 1, .values = {1.0}}};
  r.summary = summary_of(r);
  r.costs = {{.run = 0, .seconds = 0.5}};
  r.files = {{"maps/" + map, 0, "map"}};
  r.provenance_json = "{}\n";
  return r;
}

class Publication : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.file(name); }
  void write(const std::string& name, const std::string& text) const {
    fs::create_directories(fs::path(path(name)).parent_path());
    write_file(path(name), text);
  }
  void publish_with_map(const Results& results) const {
    write("runs/files/" + results.files[0].path, results.id);
    write("runs/files/maps/of_no_run.png", "left by a start that was killed");
    publish(path(""), results, "runs");
  }
  bool is_there(const std::string& name) const { return fs::exists(path(name)); }

  TemporaryFolder folder_;
};

TEST_F(Publication, TakesThePlaceOfTheOlderResultAsAWhole) {
  publish_with_map(result("old", "success", "old.png"));
  write("report.html", "the old page");
  write("figures/own.svg", "nobody listed it");
  EXPECT_TRUE(is_there("figures/success.svg"));
  EXPECT_EQ(read_text_file(path("maps/old.png")), "old");

  publish_with_map(result("new", "other", "new.png"));
  EXPECT_EQ(load_results(path("")).id, "new");
  EXPECT_EQ(read_text_file(path("maps/new.png")), "new");
  EXPECT_TRUE(is_there("figures/other.svg"));
  EXPECT_TRUE(is_there("figures/own.svg"));
  for (const char* gone : {"maps/old.png", "figures/success.svg", "figures/success.csv",
                           "report.html", "runs", ".publication", "maps/of_no_run.png"}) {
    EXPECT_FALSE(is_there(gone)) << gone;
  }
}

TEST_F(Publication, LeavesNoEmptyFolder) {
  publish_with_map(result("old", "success", "old.png"));
  Results without = result("new", "other", "");
  without.files.clear();
  fs::create_directories(path("runs/files"));
  publish(path(""), without, "runs");
  EXPECT_FALSE(is_there("maps"));
}

TEST_F(Publication, WhatIsAsWrittenIsNotTouched) {
  const Results results = result("old", "success", "old.png");
  publish_with_map(results);
  write("report.html", "the page");
  const auto before = fs::last_write_time(path("runs.csv"));
  publish(path(""), results);
  EXPECT_EQ(fs::last_write_time(path("runs.csv")), before);
  EXPECT_TRUE(is_there("report.html"));
}

TEST_F(Publication, OtherWordsOfTheSameRunsKeepTheFilesOfRuns) {
  publish_with_map(result("old", "success", "old.png"));
  publish(path(""), result("new", "other", "old.png"));
  EXPECT_EQ(load_results(path("")).id, "new");
  EXPECT_TRUE(is_there("maps/old.png"));
  EXPECT_FALSE(is_there("figures/success.svg"));
}

TEST_F(Publication, WithoutItsListTheOlderResultStands) {
  publish_with_map(result("old", "success", "old.png"));
  write(".publication/new/runs.csv", "half of it");
  finish_publication(path(""));
  EXPECT_EQ(load_results(path("")).id, "old");
  EXPECT_FALSE(is_there(".publication"));
}

// In each state that a kill can leave: removed or not, moved or not.
TEST_F(Publication, IsEndedWhereverItWasStopped) {
  for (int state = 0; state < 4; ++state) {
    SCOPED_TRACE(state);
    write("config.yaml", "old");
    write("old.csv", "old");
    write(".publication/list",
          "remove,config.yaml,\nremove,old.csv,\nmove,runs/files/map.png,maps/map.png\n"
          "move,.publication/new/config.yaml,config.yaml\ndrop,runs,\n");
    write("runs/files/map.png", "new");
    write(".publication/new/config.yaml", "new");
    if (state > 0) fs::remove(path("config.yaml"));
    if (state > 1) {
      write("maps/map.png", "new");
      fs::remove(path("runs/files/map.png"));
    }
    if (state > 2) fs::rename(path(".publication/new/config.yaml"), path("config.yaml"));
    finish_publication(path(""));
    EXPECT_EQ(read_text_file(path("config.yaml")), "new");
    EXPECT_EQ(read_text_file(path("maps/map.png")), "new");
    EXPECT_EQ(folder_.files(), 2u);
  }
}

// Somebody's folder stands where a table belongs.
TEST_F(Publication, WithoutAllOfItsFilesTheFolderIsNoResultYet) {
  write("provenance.json/own.txt", "in the way");
  EXPECT_INPUT_ERROR(publish_with_map(result("new", "success", "new.png")), "cannot be written");
  EXPECT_FALSE(is_result_folder(path("")));
  fs::remove_all(path("provenance.json"));
  finish_publication(path(""));
  EXPECT_EQ(load_results(path("")).id, "new");
}

}  // namespace
}  // namespace mapbed
