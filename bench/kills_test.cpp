// `mapbed run`, `report`, `map` and `simulate`, killed at any system call by which they change
// files, and started again.
//
// Every so many-th call; each one where MAPBED_ALL_KILLS is set.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "bench/cli/testing/command_test.h"
#include "bench/cli/testing/killed_program.h"
#include "bench/results/result_folder.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

namespace fs = std::filesystem;

// A bare room and a drive of a second: two runs, with maps, trajectories, replays, series, plots.
constexpr const char* kRoom =
    "about: a bare room\n"
    "floor: {from: [0 m, 0 m], to: [6 m, 4 m], material: concrete}\n"
    "walls:\n"
    "  - {name: south, from: [0 m, 0 m], to: [6 m, 0 m]}\n"
    "  - {name: east, from: [6 m, 0 m], to: [6 m, 4 m]}\n"
    "  - {name: north, from: [6 m, 4 m], to: [0 m, 4 m]}\n"
    "  - {name: west, from: [0 m, 4 m], to: [0 m, 0 m]}\n"
    "paths: {along: {points: [[1 m, 2 m], [5 m, 2 m]]}}\n";
constexpr const char* kWanted =
    "about: the wanted question\n"
    "world: ./room.yaml\n"
    "robot: pioneer\n"
    "recorder.longest: 1 s\n"
    "series_step: 0.5 s\n"
    "compare: {raw: {estimator: odometry}, matched: {estimator: scan_matching}}\n"
    "metrics: [translation_error, failures, position_error]\n"
    "plots: [{kind: series, y: position_error}, {y: translation_error}]\n"
    "claims: [{metric: failures, of: matched, at_most: raw},\n"
    "         {metric: run_seconds, of: matched, above: 0}]\n";
// Other runs, files and plots, and none of its own where the wanted one has some.
constexpr const char* kOther =
    "about: the other question\n"
    "world: ./room.yaml\n"
    "robot: pioneer\n"
    "recorder.longest: 1 s\n"
    "seed: 7\n"
    "sweep: {robot.odometry.rotation_sigma: [0 deg, 3 deg]}\n"
    "estimator: odometry\n"
    "metrics: [largest_error, failures]\n"
    "plots: [{y: largest_error}]\n";

// What an undisturbed run gives again to the byte.
constexpr const char* kTables[] = {"config.yaml", "runs.csv",   "summary.csv",
                                   "claims.csv",  "series.csv", "files.csv"};

bool is_the_same_each_time(const std::string& path) {
  return path != "cost.csv" && path != "cost_claims.csv" && path != "provenance.json" &&
         path != "report.html";
}

class Kills : public CommandTest {
 protected:
  Kills() {
    write("room.yaml", kRoom);
    write("wanted.yaml", kWanted);
    write("other.yaml", kOther);
    EXPECT_EQ(call(run_of("wanted", "whole")).status, 0);
    EXPECT_EQ(call(run_of("other", "other")).status, 0);
  }

  static std::vector<std::string> run_of(const std::string& scenario, const std::string& folder) {
    return {"run", "./" + scenario + ".yaml", "-j", "1", "--out", folder};
  }

  // All that is in a folder, hidden or not, by path.
  std::map<std::string, std::string> files_in(const std::string& folder) const {
    std::map<std::string, std::string> files;
    if (!fs::exists(path(folder))) return files;
    for (const auto& entry : fs::recursive_directory_iterator(path(folder))) {
      const std::string name = fs::relative(entry.path(), path(folder)).string();
      files[name] = entry.is_directory() ? "a folder" : read_text_file(entry.path().string());
    }
    return files;
  }

  // Every so many-th call, or each.
  static int step(int usual) { return std::getenv("MAPBED_ALL_KILLS") != nullptr ? 1 : usual; }

  void expect_as_undisturbed(const std::string& folder, const std::string& reference,
                             const std::string& not_asked) const {
    const auto files = files_in(folder);
    const auto expected = files_in(reference);
    for (const auto& [name, content] : expected) {
      const auto found = files.find(name);
      ASSERT_NE(found, files.end()) << name << " is missing";
      EXPECT_TRUE(!is_the_same_each_time(name) || found->second == content) << name;
    }
    for (const auto& [name, content] : files) {
      EXPECT_TRUE(expected.contains(name)) << name << " is too much";
    }
    EXPECT_THAT(files.at("report.html"), Not(HasSubstr(not_asked)));
  }

  // What shows itself as a result is one, of whatever configuration, and no mixture.
  void expect_whole_or_none(const std::string& folder, const std::string& before) const {
    if (!is_result_folder(path(folder))) return;
    const auto files = files_in(folder);
    const auto is_of = [&](const std::string& reference) {
      const auto expected = files_in(reference);
      return std::all_of(std::begin(kTables), std::end(kTables), [&](const char* name) {
        const bool is_expected = expected.contains(name);
        return is_expected == files.contains(name) &&
               (!is_expected || files.at(name) == expected.at(name));
      });
    };
    EXPECT_TRUE(is_of("whole") || is_of("other") || (!before.empty() && is_of(before)));
  }

  // Kills the run in `result`, which is `before` at first, at every so many-th call; `again` has to
  // make it as it is in `reference`.
  void kill_everywhere(const std::string& before, const std::vector<std::string>& killed,
                       const std::vector<std::string>& again, const std::string& reference,
                       const std::string& not_asked, int every = 23) {
    int kills = 0;
    for (int nth = 1;; nth += step(every)) {
      SCOPED_TRACE(fmt::format("killed at call {}", nth));
      fs::remove_all(path("result"));
      if (!before.empty()) fs::copy(path(before), path("result"), fs::copy_options::recursive);
      const std::optional<KilledRun> run = run_killed_at(nth, killed, path());
      if (!run) GTEST_SKIP() << "the system lets no program trace another";
      if (!run->was_killed) {
        EXPECT_EQ(run->status, 0);
        EXPECT_GT(kills, 5) << "of " << run->calls << " calls that were seen";
        fmt::print("{} kills, at {} calls\n", kills, run->calls);
        break;
      }
      ++kills;
      expect_whole_or_none("result", before);
      const Outcome outcome = call(again);
      ASSERT_EQ(outcome.status, 0) << outcome.err;
      expect_as_undisturbed("result", reference, not_asked);
      if (HasFailure()) return;
    }
    std::vector<std::string> beside;
    for (const auto& entry : fs::directory_iterator(path())) {
      beside.push_back(entry.path().filename().string());
    }
    const std::vector<std::string> known{"other",       "other.yaml", "result", "room.yaml",
                                         "wanted.yaml", "whole",      "before"};
    for (const std::string& name : beside) {
      EXPECT_THAT(known, ::testing::Contains(name)) << "litter";
    }
  }
};

TEST_F(Kills, InAnEmptyFolderGiveTheSameBytes) {
  const auto run = run_of("wanted", "result");
  kill_everywhere("", run, run, "whole", "the other question");
}

TEST_F(Kills, OverAFinishedResultOfAnotherConfigurationLeaveNothingOfIt) {
  const auto run = run_of("wanted", "result");
  kill_everywhere("other", run, run, "whole", "the other question");
}

TEST_F(Kills, OverAnUnfinishedOneOfAnotherConfigurationLeaveNothingOfIt) {
  // Killed with a run in the journal.
  for (int nth = 1;; ++nth) {
    fs::remove_all(path("before"));
    const auto run = run_killed_at(nth, run_of("other", "before"), path());
    if (!run) GTEST_SKIP() << "the system lets no program trace another";
    ASSERT_TRUE(run->was_killed);
    const std::string journal = path("before/runs/journal");
    if (fs::exists(journal) && fs::file_size(journal) > 250) break;
  }
  EXPECT_THAT(call(run_of("wanted", "before")).err, HasSubstr("--restart throws these runs away"));
  auto run = run_of("wanted", "result");
  run.push_back("--restart");
  kill_everywhere("before", run, run, "whole", "the other question");
}

// The other configuration is wanted back, whose place the killed one was about to take.
TEST_F(Kills, ThenTheOtherConfigurationAgainGivesItsOwnBytes) {
  auto again = run_of("other", "result");
  again.push_back("--restart");
  kill_everywhere("other", run_of("wanted", "result"), again, "other", "the wanted question");
}

TEST_F(Kills, OfAFinishedResultThatGetsOtherWordsDoNoHarm) {
  write("wanted.yaml", std::string(kWanted) + "thesis: in other words\n");
  const auto run = run_of("wanted", "result");
  fs::copy(path("whole"), path("before"), fs::copy_options::recursive);
  EXPECT_EQ(call(run_of("wanted", "whole")).status, 0);
  kill_everywhere("before", run, run, "whole", "the other question", 5);  // no runs are made
}

// What is written once the work is done, over what an earlier start has left in `kept`.
class KilledAtTheEnd : public CommandTest {
 protected:
  std::map<std::string, std::string> files(const std::string& folder) const {
    std::map<std::string, std::string> found;
    for (const auto& entry : fs::directory_iterator(path(folder))) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with('.')) continue;
      found[name] = name == "cost.csv" ? "other each time" : read_text_file(entry.path().string());
    }
    return found;
  }

  // `mark` says that the files of the folder belong together.
  void expect_older_or_newer(const std::vector<std::string>& older,
                             const std::vector<std::string>& newer, const std::string& mark) {
    ASSERT_EQ(call(newer).status, 0);
    const auto wanted = files("kept");
    fs::remove_all(path("kept"));
    fs::create_directory(path("kept"));
    ASSERT_EQ(call(older).status, 0);
    const auto before = files("kept");
    fs::rename(path("kept"), path("before"));
    int kills = 0;
    for (int nth = 1;; nth += std::getenv("MAPBED_ALL_KILLS") != nullptr ? 1 : 5, ++kills) {
      SCOPED_TRACE(fmt::format("killed at call {}", nth));
      fs::remove_all(path("kept"));
      fs::copy(path("before"), path("kept"), fs::copy_options::recursive);
      const std::optional<KilledRun> run = run_killed_at(nth, newer, path());
      if (!run) GTEST_SKIP() << "the system lets no program trace another";
      const auto found = files("kept");
      if (found.contains(mark)) {
        EXPECT_TRUE(found == before || found == wanted);
      }
      const Outcome outcome = call(newer);
      ASSERT_EQ(outcome.status, 0) << outcome.err;
      EXPECT_TRUE(files("kept") == wanted);
      for (const auto& entry : fs::directory_iterator(path("kept"))) {
        EXPECT_FALSE(entry.path().filename().string().starts_with('.')) << "litter: " << entry;
      }
      if (!run->was_killed || HasFailure()) break;
    }
    EXPECT_GT(kills, 5);
  }
};

std::vector<std::string> drive(const std::string& seed) {
  return {"simulate",  "--world", "corridor",
          "--robot",   "pioneer", "--people",
          "0",         "--set",   "recorder.longest=2 s",
          "--seed",    seed,      "-o",
          "kept/a.log"};
}

TEST_F(KilledAtTheEnd, ASimulationIsTheOlderOrTheNewerOneWhereItHasALog) {
  fs::create_directory(path("kept"));
  expect_older_or_newer(drive("1"), drive("2"), "a.log");
}

TEST_F(KilledAtTheEnd, AMapIsTheOlderOrTheNewerOneWhereItHasASummary) {
  fs::create_directory(path("kept"));
  ASSERT_EQ(call(drive("1")).status, 0);
  fs::rename(path("kept"), path("log"));
  const auto map = [](const char* method) {
    return std::vector<std::string>{"map", "log/a.log", "--method", method, "--out", "kept"};
  };
  expect_older_or_newer(map("odometry"), map("scan_matching"), "summary.json");
}

// Results of an older program, which drew and judged otherwise, with their pages.
class KilledReport : public Kills {
 protected:
  KilledReport() {
    fs::create_directory(path("old"));
    for (const char* name : {"whole", "other"}) {
      fs::copy(path(name), path("old/" + std::string(name)), fs::copy_options::recursive);
    }
    EXPECT_EQ(call({"report", "old"}).status, 0);
    write("old/notes.txt", "somebody's own\n");
    fs::copy(path("old"), path("new"), fs::copy_options::recursive);
    for (const auto& [name, content] : files_in("old")) {
      const bool is_page = name.ends_with(".html") || name.ends_with(".md");
      if (is_page || name.ends_with(".svg")) write("old/" + name, content + "<!-- older -->\n");
      if (name.ends_with("claims.csv")) write("old/" + name, "claim,held,measured,thesis\n");
    }
  }

  // Of the files in that folder; hidden ones belong to nobody.
  static std::map<std::string, std::string> part(const std::map<std::string, std::string>& files,
                                                 const std::string& folder) {
    std::map<std::string, std::string> inner;
    for (const auto& [name, content] : files) {
      const bool is_hidden = name.find("/.") != std::string::npos || name.starts_with('.');
      if (name.starts_with(folder) && !is_hidden) inner.emplace(name, content);
    }
    return inner;
  }
};

TEST_F(KilledReport, LeavesEachResultWithItsPageAndTheNextOneMakesAll) {
  const auto older = files_in("old");
  const auto newer = files_in("new");
  int kills = 0;
  for (int nth = 1;; nth += step(7)) {
    SCOPED_TRACE(fmt::format("killed at call {}", nth));
    fs::remove_all(path("result"));
    fs::copy(path("old"), path("result"), fs::copy_options::recursive);
    const std::optional<KilledRun> run = run_killed_at(nth, {"report", "result"}, path());
    if (!run) GTEST_SKIP() << "the system lets no program trace another";
    EXPECT_THAT(files_in("result"), testing::IsSupersetOf(part(older, "notes.txt")));
    for (const char* name : {"whole/", "other/"}) {
      if (!is_result_folder(path("result/" + std::string(name)))) continue;
      const auto found = part(files_in("result"), name);
      EXPECT_TRUE(found == part(older, name) || found == part(newer, name)) << name;
    }
    if (run->was_killed) ++kills;
    const Outcome outcome = call({"report", "result"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(files_in("result") == newer);
    if (!run->was_killed || HasFailure()) break;
  }
  EXPECT_GT(kills, 10);
}

}  // namespace
}  // namespace mapbed
