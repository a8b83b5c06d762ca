// `mapbed run` from a scenario file to its results.

#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "bench/cli/testing/command_test.h"
#include "bench/results/result_folder.h"
#include "core/data_path.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

namespace fs = std::filesystem;

// 24 runs on 6 recordings of four seconds.
constexpr const char* kDrives =
    "about: a few short drives\n"
    "world: office\n"
    "robot: pioneer\n"
    "people: 2\n"
    "recorder.longest: 4 s\n"
    "sweep: {robot.odometry.rotation_sigma: [0 deg, 3 deg]}\n"
    "compare: {raw: {estimator: odometry}, matched: {estimator: scan_matching}}\n"
    "seeds: 6\n"
    "series_step: 1 s\n"
    "metrics: [translation_error, largest_error, failures, map_f1, position_error]\n"
    "plots: [{kind: series, y: position_error}]\n"
    "claims: [{metric: failures, of: matched, at_most: raw},\n"
    "         {metric: real_time_factor, of: matched, above: 1},\n"
    "         {series: position_error, of: matched, at_most: 1 m, at: {time: 2 s}}]\n";

class RunCommand : public CommandTest {
 protected:
  RunCommand() { write("drives.yaml", kDrives); }

  Outcome run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"run", "./drives.yaml"});
    return call(arguments);
  }
  void expect_same_results(const std::string& a, const std::string& b) const {
    for (const char* name : {"config.yaml", "runs.csv", "summary.csv", "claims.csv", "series.csv",
                             "files.csv", "figures/position_error.svg"}) {
      EXPECT_EQ(read_text_file(path(a + "/" + name)), read_text_file(path(b + "/" + name))) << name;
    }
    for (const auto& entry : fs::recursive_directory_iterator(path(a))) {
      const fs::path other = path(b) / fs::relative(entry.path(), path(a));
      ASSERT_TRUE(fs::exists(other)) << other;
      const bool is_picture =
          entry.path().extension() == ".png" || entry.path().extension() == ".tum";
      if (!is_picture) continue;
      EXPECT_EQ(read_text_file(entry.path()), read_text_file(other)) << other;
    }
    EXPECT_FALSE(fs::exists(path(b + "/runs")));
  }
};

TEST_F(RunCommand, GivesTheSameBytesWithAnyNumberOfThreads) {
  for (const char* threads : {"1", "2", "8"}) {
    const Outcome outcome = run({"-j", threads, "--out", std::string("j") + threads});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("6 recordings made"));
  }
  expect_same_results("j1", "j2");
  expect_same_results("j1", "j8");
  const Results results = load_results(path("j1"));
  EXPECT_EQ(results.runs.size(), 24u);
  EXPECT_EQ(results.summary.size(), 2u * 2u * 4u);
  EXPECT_EQ(results.series.size(), 24u);
  EXPECT_EQ(results.verdicts.size(), 3u);
  EXPECT_THAT(text("j1/claims.csv"), ::testing::Not(HasSubstr("real_time_factor")));
  EXPECT_THAT(text("j1/cost_claims.csv"), HasSubstr("real_time_factor of 'matched' is above 1"));
}

TEST_F(RunCommand, GoesOnAfterAKillAtAnyMoment) {
  ASSERT_EQ(run({"-j", "2", "--out", "whole"}).status, 0);
  // Killed as soon as more than so many lines, of 25, are in the journal.
  for (int round = 0; round < 12; ++round) {
    SCOPED_TRACE(round);
    fs::remove_all(path("cut"));
    const Outcome killed = run_shell(
        fmt::format("$MAPBED run ./drives.yaml -j 2 --out cut & p=$!\n"
                    "while kill -0 $p && [ $(wc -l < cut/runs/journal || echo 0) -le {} ]; do :; "
                    "done\n"
                    "kill -KILL $p; wait $p",
                    round),
        path());
    EXPECT_EQ(killed.status, 128 + 9);
    const Outcome outcome = run({"-j", "2", "--out", "cut"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    expect_same_results("whole", "cut");
  }
}

TEST_F(RunCommand, RepeatsOneRunAlone) {
  ASSERT_EQ(run({"--out", "all"}).status, 0);
  const Outcome outcome = run({"--run", "17"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string row = outcome.out.substr(outcome.out.find('\n') + 1);
  EXPECT_THAT(row, ::testing::StartsWith("17,"));
  EXPECT_THAT(read_text_file(path("all/runs.csv")), HasSubstr(row));
}

TEST_F(RunCommand, DoesNothingTwice) {
  ASSERT_EQ(run({"--out", "r"}).status, 0);
  const std::string before = read_text_file(path("r/provenance.json"));
  const Outcome again = run({"--out", "r"});
  EXPECT_THAT(again.out, HasSubstr("24 were done before, 0 recordings made"));
  EXPECT_EQ(read_text_file(path("r/provenance.json")), before);
}

TEST_F(RunCommand, AFinishedTableThatWasChangedIsNotTakenForComplete) {
  const std::vector<std::string> arguments{"--set", "seeds=1", "-j", "1", "--out", "r"};
  ASSERT_EQ(run(arguments).status, 0);
  const std::string runs = text("r/runs.csv");
  const std::string provenance = text("r/provenance.json");
  const auto refuse = [&](const std::string& changed, const std::string& message) {
    write("r/runs.csv", changed);
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_EQ(text("r/runs.csv"), changed) << "nothing is done unasked";
  };
  const std::size_t head = runs.find('\n') + 1;
  const std::string first = runs.substr(head, runs.find('\n', head) + 1 - head);
  const std::string lost = runs.substr(0, head) + runs.substr(head + first.size());
  refuse(lost, "r/runs.csv: is not the table that was written");
  refuse(runs + first, "r/runs.csv: is not the table that was written");
  // Of a program that wrote no checksums.
  write("r/provenance.json",
        std::string(provenance).replace(provenance.find("tables_"), 6, "others"));
  refuse(lost, "r/runs.csv: has not each of the 4 runs once");
  refuse(runs + first, "r/runs.csv: has not each of the 4 runs once");
  write("r/runs.csv", runs);
  EXPECT_EQ(run(arguments).status, 0);
}

TEST_F(RunCommand, AFinishedConfigurationLeavesTheUnfinishedRunsOfAnother) {
  const auto run_seeds = [&](const char* seeds, const char* more = "") {
    return run_shell(
        fmt::format("$MAPBED run ./drives.yaml --set seeds={} -j 1 --out r {}", seeds, more),
        path());
  };
  ASSERT_EQ(run_seeds("1").status, 0);
  EXPECT_EQ(run_seeds("5",
                      "& p=$!; until [ $(wc -l < r/runs/journal || echo 0) -gt 3 ]; do :; done; "
                      "kill -KILL $p; wait $p")
                .status,
            128 + 9);
  EXPECT_THAT(run_seeds("1").out, HasSubstr("4 were done before"));
  EXPECT_TRUE(fs::exists(path("r/runs/journal")));
  const Outcome outcome = run_seeds("5");
  EXPECT_THAT(outcome.out, HasSubstr("20 runs"));
  EXPECT_THAT(outcome.out, ::testing::Not(HasSubstr("; 0 were done before")));
  EXPECT_FALSE(fs::exists(path("r/runs")));
}

TEST_F(RunCommand, WritesOverNothingOfSomebodyElse) {
  fs::create_directory(path("r"));
  const std::vector<std::string> arguments{"--set", "seeds=1", "--out", "r"};
  for (const char* name : {"report.html", "config.yaml", "summary.csv"}) {
    write(std::string("r/") + name, "of my own");
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr(std::string("r/") + name));
    EXPECT_EQ(text(std::string("r/") + name), "of my own");
    fs::remove(path(std::string("r/") + name));
  }
  EXPECT_TRUE(fs::is_empty(path("r")));
}

TEST_F(RunCommand, NamesThatAreNoTextLoseNothing) {
  const Outcome refused = run_shell(
      "cp drives.yaml \"$(printf 'b\\344r.yaml')\"; "
      "$MAPBED run \"./$(printf 'b\\344r.yaml')\" --out r",
      path());
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("is not UTF-8; rename the file"));
  const Outcome outcome = run_shell(
      "mkdir \"$(printf 'b\\344r')\"; cp drives.yaml \"$(printf 'b\\344r')\"; "
      "$MAPBED run \"$(printf 'b\\344r')/drives.yaml\" --set seeds=1 --out r",
      path());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(text("r/provenance.json"), HasSubstr("b\\\\xE4r/drives.yaml"));
}

TEST_F(RunCommand, TwoThingsOfOneFileNameAreToldApartOrRefused) {
  write("same.yaml",
        "base: drives.yaml\nseeds: 1\nsweep: {}\nclaims: []\n"
        "compare: {\u00e4: {estimator: odometry}, \u00f6: {estimator: scan_matching}}\n");
  ASSERT_EQ(call({"run", "./same.yaml", "--out", "r"}).status, 0);
  EXPECT_NE(text("r/maps/map_variant_0.png"), text("r/maps/map_variant_1.png"));
  write("plots.yaml", "base: drives.yaml\nplots: [{y: failures}, {file: failures, y: map_f1}]\n");
  expect_refusal({"run", "./plots.yaml"}, "two plots have the name 'failures'");
}

TEST_F(RunCommand, OtherPlotsAndClaimsNeedNoOtherRuns) {
  write("other.yaml", "base: drives.yaml\nabout: in other words\nplots: [{y: largest_error}]\n");
  const auto run_into_r = [&](const std::string& scenario) {
    return call({"run", scenario, "--set", "seeds=2", "--out", "r"});
  };
  ASSERT_EQ(run_into_r("./drives.yaml").status, 0);
  const Outcome again = run_into_r("./other.yaml");
  EXPECT_THAT(again.out, HasSubstr("8 were done before, 0 recordings made"));
  EXPECT_THAT(read_text_file(path("r/report.html")), HasSubstr("in other words"));
  const std::string figure = path("r/figures/largest_error.svg");
  const std::string drawn = read_text_file(figure);

  fs::remove(figure);
  EXPECT_EQ(call({"report", "r"}).status, 0);
  EXPECT_EQ(read_text_file(figure), drawn);

  run_into_r("./drives.yaml");
  EXPECT_FALSE(fs::exists(figure));
}

TEST_F(RunCommand, AnEditedFileIsToldAndRunAnew) {
  write("room.yaml", "start: corridor\n");
  write("own.yaml",
        "world: room.yaml\nrobot: pioneer\npeople: 0\nrecorder.longest: 1 s\n"
        "estimator: odometry\nmetrics: [path_length]\n");
  const auto run_own = [&] { return call({"run", "./own.yaml", "--out", "r"}); };
  EXPECT_EQ(run_own().err, "");
  EXPECT_THAT(run_own().out, HasSubstr("1 were done before"));
  write("room.yaml", "start: corridor\noptions: {length: 14 m}\n");
  const Outcome anew = run_own();
  EXPECT_EQ(anew.status, 0);
  EXPECT_EQ(anew.err, "remark: " + portable_path(path("room.yaml")) +
                          " changed since r/config.yaml was written; all runs are done anew\n");
  EXPECT_THAT(anew.out, HasSubstr("0 were done before"));
  write("room.yaml", "start: corridor\n");
  EXPECT_THAT(call({"run", "r/config.yaml", "--out", "s"}).err,
              HasSubstr("room.yaml changed since r/config.yaml was written; the results may be "
                        "others"));
}

TEST_F(RunCommand, TheExitStatusTellsWhetherClaimsHold) {
  write("no.yaml", "base: drives.yaml\nseeds: 1\nclaims: [{metric: largest_error, below: 0 m}]\n");
  const auto status = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"run", "./no.yaml", "--out", "no"});
    return call(more).status;
  };
  EXPECT_EQ(status({}), 0);
  EXPECT_EQ(status({"--strict"}), 2);
}

TEST_F(RunCommand, AQuickRunSaysThatItDoesNotJudge) {
  write("short.yaml", "base: drives.yaml\nseeds: 2\nquick: {set: {recorder.longest: 1 s}}\n");
  const Outcome outcome = call({"run", "./short.yaml", "--quick", "--strict", "--out", "q"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("quick: not judged failures of 'matched'"));
  EXPECT_THAT(outcome.out, ::testing::Not(::testing::AnyOf(HasSubstr("held"), HasSubstr("HELD"))));
  EXPECT_FALSE(load_results(path("q")).verdicts.at(0).judged);
}

TEST_F(RunCommand, AFinishedResultOfSomethingElseIsNotReplacedSilently) {
  write("short.yaml", "base: drives.yaml\nseeds: 2\nrecorder.longest: 1 s\n");
  const auto run_into = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"run", "./short.yaml", "--out", "r"});
    return call(more);
  };
  ASSERT_EQ(run_into({}).status, 0);
  const std::string before = text("r/runs.csv");
  EXPECT_THAT(run_into({}).err, ::testing::Not(HasSubstr("takes its place")));

  const Outcome quick = run_into({"--quick", "--seed", "7"});
  EXPECT_EQ(quick.status, 1);
  EXPECT_THAT(quick.err, HasSubstr("r: holds a result of full size, whose place a quick one would "
                                   "take; name another folder with --out"));
  EXPECT_EQ(text("r/runs.csv"), before);

  const Outcome other = run_into({"--seed", "7"});
  EXPECT_EQ(other.status, 0) << other.err;
  EXPECT_THAT(other.err, HasSubstr("remark: r holds the finished result of another version of the "
                                   "program, of the scenario or of its settings"));
}

TEST_F(RunCommand, RefusesBadInputInOneLine) {
  const auto refuse = [&](const std::vector<std::string>& arguments, const std::string& message) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr(message));
  };
  refuse({"--set", "robot.odometry.rotaton_sigma=1 deg"}, "did you mean 'rotation_sigma'?");
  refuse({"--set", "seeds=0"}, "too small");
  refuse({"--set", "seeds=90000"}, "this makes 360000 runs");
  refuse({"--set", "robot=pionier"}, "did you mean 'pioneer'?");
  refuse({"--out", "/proc/results"}, "/proc/results: cannot be made");
  refuse({"--run", "24"}, "there is no run 24");
  const Outcome unknown = call({"run", "ch2_raw_odometri"});
  EXPECT_EQ(unknown.status, 1);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean 'ch2_raw_odometry'?"));
}

TEST_F(RunCommand, ALogThatIsNotHereIsSkippedInWords) {
  write("away.yaml",
        fmt::format("about: a\nfile: away.log\nsha256: {:a>64}\nsource: s\nlicence: l\n"
                    "fetch: f\nrobot: r\nlaser: x\n",
                    "b"));
  write("real.yaml",
        "about: recorded logs\nlog.longest: 3 s\nseeds: 2\nmetrics: [path_length, largest_error]\n"
        "compare: {here: {log: example}, away: {log: ./away.yaml}}\n"
        "claims: [{metric: largest_error, of: here, at_most: away}]\n");
  const Outcome outcome = call({"run", "./real.yaml", "--out", "r"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("2 runs, 0 of them failed"));
  EXPECT_THAT(outcome.out,
              HasSubstr("remark: the log '" + path("away.yaml") +
                        "' is not here (away.log): 2 runs skipped; set MAPBED_DATA to the folder "
                        "that holds it"));
  EXPECT_THAT(outcome.out, HasSubstr("not judged"));
  EXPECT_EQ(load_results(path("r")).runs.size(), 2u);
  EXPECT_THAT(read_text_file(path("r/report.html")), HasSubstr("is not here (away.log)"));

  const Outcome none = call({"run", "./real.yaml", "--set", "log=./away.yaml"});
  EXPECT_EQ(none.status, 1);
  EXPECT_THAT(none.err, HasSubstr("real.yaml: the log '" + path("away.yaml") +
                                  "' is not here (away.log); set MAPBED_DATA"));
}

TEST_F(RunCommand, TwoAtOnceInOneFolderAreOneTooMany) {
  const Outcome outcome = run_shell(
      "mkdir r; flock r/.lock sh -c 'touch held; while [ -e held ]; do sleep 0.1; done' & "
      "until [ -e held ]; do sleep 0.1; done; $MAPBED run ./drives.yaml --out r; s=$?; "
      "rm held; wait; exit $s",
      path());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("another run is at work in this folder"));
}

TEST_F(RunCommand, AFullDiskIsToldAndNothingIsLost) {
  // 1 KiB is the most that a file may grow to.
  const Outcome full =
      run_shell("trap '' XFSZ; ulimit -f 1; $MAPBED run ./drives.yaml -j 1 --out r", path());
  EXPECT_EQ(full.status, 1);
  EXPECT_THAT(full.err, HasSubstr("r/runs/"));
  const Outcome after = run({"-j", "1", "--out", "r"});
  EXPECT_EQ(after.status, 0) << after.err;
  ASSERT_EQ(run({"-j", "1", "--out", "whole"}).status, 0);
  expect_same_results("whole", "r");
}

}  // namespace
}  // namespace mapbed
