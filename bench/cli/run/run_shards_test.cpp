// `mapbed run` with --shard, --slurm and --status, as far as they need no Slurm.

#include <filesystem>

#include <gmock/gmock.h>

#include "bench/cli/testing/shard_command_test.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

namespace fs = std::filesystem;

class RunShards : public ShardCommand {
 protected:
  // A program in a folder bin/ of its own.
  void program(const std::string& name, const std::string& script) const {
    fs::create_directory(path("bin"));
    write("bin/" + name, "#!/bin/sh\n" + script + "\n");
    fs::permissions(path("bin/" + name), fs::perms::owner_all);
  }
  Outcome with_programs(const std::string& arguments) const {
    return shell("PATH=$PWD/bin:$PATH $MAPBED run ./sweep.yaml --out r " + arguments);
  }
  Outcome without_slurm(const std::string& arguments) const {
    fs::create_directories(path("shell"));
    if (!exists("shell/sh")) fs::create_symlink("/bin/sh", path("shell/sh"));
    return shell("PATH=$PWD/shell $MAPBED run ./sweep.yaml --out r " + arguments);
  }
};

TEST_F(RunShards, AtOnceWithOneThatIsKilledGiveTheTablesOfOneMachine) {
  write("hold_4", "");
  const Outcome outcome = shell(
      "for k in 1 2 3; do $MAPBED run ./sweep.yaml -j 1 --shard $k/4 --out r & done\n"
      "SLURM_ARRAY_TASK_ID=4 $MAPBED run ./sweep.yaml -j 1 --shard 4/4 --out r & p=$!\n"
      "while kill -0 $p && [ ! -e held_4 ]; do sleep 0.05; done\n"
      "kill -KILL $p; wait $p; status=$?; wait; exit $status");
  EXPECT_EQ(outcome.status, 128 + 9) << outcome.err;
  EXPECT_FALSE(exists("r/config.yaml"));
  const Outcome last = run({"--shard", "4/4"});
  ASSERT_EQ(last.status, 0) << last.err;
  EXPECT_THAT(last.out, HasSubstr("shard 4/4: 12 of 12 runs, "));
  EXPECT_THAT(last.out, Not(HasSubstr(" 0 of them done before")));
  EXPECT_THAT(last.out, HasSubstr("of all shards 48 of 48 are in\n"));
  EXPECT_THAT(last.out, HasSubstr("48 runs, 0 of them failed; 48 were done before"));
  expect_as_on_one_machine();
}

TEST_F(RunShards, AreToldAndMergedWhenAllAreIn) {
  program("squeue", "");
  EXPECT_THAT(with_programs("--status").out, HasSubstr("sweep: 0 of 48 runs are in\n"));
  EXPECT_FALSE(exists("r")) << "asking makes nothing";
  const Outcome first = run({"--shard", "1/2"});
  EXPECT_EQ(first.status, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("of all shards 24 of 48 are in\n"));
  const Outcome half = with_programs("--status");
  EXPECT_EQ(half.status, 3);
  EXPECT_THAT(half.out, HasSubstr("24 of 48 runs are in\n"));
  EXPECT_THAT(half.out, HasSubstr("shard 1/2       24 of 24 runs, done\n"));
  EXPECT_THAT(half.out, HasSubstr("shard 2/2       0 of 24 runs, not begun\n"));
  EXPECT_THAT(half.out, HasSubstr("start what is not at work with --slurm 2, or --shard 2/2;"));
  ASSERT_EQ(run({"--shard", "2/2"}).status, 0);
  EXPECT_EQ(with_programs("--status").status, 0);
  expect_as_on_one_machine();
}

TEST_F(RunShards, ThatWereInterruptedGoOn) {
  program("squeue", "");
  write("hold_1", "");
  const Outcome interrupted = shell(
      "SLURM_ARRAY_TASK_ID=1 $MAPBED run ./sweep.yaml -j 1 --shard 1/2 --out r & p=$!\n"
      "while kill -0 $p && [ ! -e held_1 ]; do sleep 0.05; done\n"
      "kill -TERM $p; wait $p");
  EXPECT_EQ(interrupted.status, 3);
  EXPECT_THAT(interrupted.err, HasSubstr("mapbed: interrupted after "));
  EXPECT_THAT(interrupted.err, HasSubstr(" of 24 runs; start again to go on\n"));
  EXPECT_THAT(with_programs("--status").out, HasSubstr(" of 24 runs, stopped\n"));
  ASSERT_EQ(run({"--shard", "2/2"}).status, 0);
  EXPECT_FALSE(exists("r/config.yaml"));
  EXPECT_THAT(run({"-j", "2"}).out, HasSubstr("48 runs, 0 of them failed; "));
  expect_as_on_one_machine();
}

TEST_F(RunShards, OfAChangedScenarioAreRefused) {
  ASSERT_EQ(run({"--shard", "1/2"}).status, 0);
  const char* const message =
      "r/shards/1_of_2/runs/journal: these runs are of another version of the scenario, other "
      "settings or another seed; let all shards have the same; --restart throws these runs away";
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--shard", "2/2"}, {"--status"}, {"-j", "2"}}) {
    std::vector<std::string> arguments{"run", "./sweep.yaml", "--out",
                                       "r",   "--set",        "recorder.longest=3 s"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_refusal(arguments, message);
  }
}

TEST_F(RunShards, OfAFinishedResultAreNotDoneAgain) {
  ASSERT_EQ(run({"-j", "2"}).status, 0);
  const Outcome shard = run({"--shard", "2/3"});
  EXPECT_EQ(shard.status, 0) << shard.err;
  EXPECT_THAT(shard.out, HasSubstr("48 were done before, 0 recordings made"));
  expect_refused(run({"--shard", "2/3", "--restart"}), "r: all runs of this result are done");
}

TEST_F(RunShards, OfAResultThatAnotherConfigurationMadeNoneIsMissing) {
  ASSERT_EQ(run({}).status, 0);
  EXPECT_EQ(with_programs("--status").status, 0);
  const Outcome other = with_programs("--status --seed 7");
  EXPECT_EQ(other.status, 1);
  EXPECT_THAT(other.err,
              HasSubstr("r: holds the finished result of another version of the program, of the "
                        "scenario or of its settings, and no shard has begun to make it anew; "
                        "start shards where it shall be made anew"));
}

TEST_F(RunShards, WithWrongWordsAreRefusedInOneLine) {
  const auto refuse = [&](const std::vector<std::string>& more, const std::string& message) {
    expect_refused(run(more), message);
  };
  for (const char* text : {"3/0", "9/8", "a/b", "3", "1/1001"}) {
    refuse({"--shard", text}, std::string("'") + text + "' is no shard; --shard 3/8 is the third");
  }
  refuse({"--shard", "1/2", "--status"}, "--run, --shard, --slurm and --status exclude each other");
  refuse({"--status", "--restart"}, "--status and --restart exclude each other");
  refuse({"--slurm", "0"}, "--slurm");
  refuse({"more"}, "one argument too many: 'more'; see 'mapbed run --help'");
  refuse({"--slurm", "2", "--", "--array=1-9"}, "sbatch's option --array is chosen by mapbed");
  refuse({"--slurm", "2", "--", "-D/tmp"}, "sbatch's option -D is chosen by mapbed");
  EXPECT_FALSE(exists("r"));
}

TEST_F(RunShards, WithoutSlurmTheRemedyIsTold) {
  expect_refused(without_slurm("--slurm 2"),
                 "squeue: there is no such program in PATH; call this where Slurm is, or hand each "
                 "'--shard 1/8', '2/8', … to another scheduler");
  const Outcome status = without_slurm("--status");
  EXPECT_EQ(status.status, 3);
  EXPECT_EQ(status.out, "sweep: 0 of 48 runs are in\n");
  EXPECT_FALSE(exists("r"));
}

TEST_F(RunShards, WhatSlurmRefusesIsTold) {
  program("squeue", "");
  program("sbatch", "echo 'sbatch: error: invalid partition' >&2; exit 1");
  expect_refused(with_programs("--slurm 2 -- -p x"),
                 "sbatch: ended with exit status 1: sbatch: error: invalid partition; see what");
  EXPECT_FALSE(exists("r")) << "nothing is left of it";
  program("sbatch", "echo something else");
  expect_refused(with_programs("--slurm 2"), "sbatch: names no job: something else; see what");
  program("squeue", "echo 'squeue: error: no controller' >&2; exit 1");
  expect_refused(with_programs("--slurm 2"), "squeue: ended with exit status 1: squeue: error: no");
  const std::string told = "remark: squeue: ended with exit status 1: squeue: error: no";
  ASSERT_EQ(run({"--shard", "1/2"}).status, 0);
  Outcome status = with_programs("--status");
  EXPECT_EQ(status.status, 3) << "the journals tell enough";
  EXPECT_THAT(status.out, Not(HasSubstr(told))) << "nothing of it was submitted";
  program("squeue", "");
  program("sbatch", "echo 12");
  ASSERT_EQ(with_programs("--slurm 2").status, 0);
  program("squeue", "echo 'squeue: error: no controller' >&2; exit 1");
  status = with_programs("--status");
  EXPECT_EQ(status.status, 3);
  EXPECT_THAT(status.out, HasSubstr(told));
}

// What the programs of Slurm get and answer, by two that note and do the same.
TEST_F(RunShards, AreSubmittedAsAnArrayAndThoseThatAreDoneNotAgain) {
  program("squeue", "cat queue 2>/dev/null || true");
  program("sbatch", "printf '%s\\n' \"$@\" >words; echo 'sbatch: a remark' >&2; echo '12;cluster'");
  ASSERT_EQ(run({"--shard", "2/3"}).status, 0);
  const Outcome submitted = with_programs("--slurm 3 -j 2 -- -p 'a b'");
  ASSERT_EQ(submitted.status, 0) << submitted.err;
  EXPECT_THAT(submitted.out, HasSubstr("shard 1/3       0 of 16 runs, submitted\n"));
  EXPECT_THAT(submitted.out, HasSubstr("shard 2/3       16 of 16 runs, done\n"));
  EXPECT_THAT(submitted.out, HasSubstr("submitted as job 12\n"));
  EXPECT_THAT(text("words"), HasSubstr("\n--cpus-per-task=2\n"));
  EXPECT_THAT(text("words"), HasSubstr("\n-p\na b\n--parsable\n--array=1,3\n--job-name="));
  EXPECT_THAT(text("words"), HasSubstr("/r/shards/slurm/%a_of_3.txt\n"));

  const std::string words = text("words");
  const std::size_t name = words.find("--job-name=") + 11;
  write("queue", words.substr(name, words.find('\n', name) - name) + "|3|PENDING|Resources\n");
  write("r/shards/slurm/1_of_3.txt", "planning\nslurmstepd: error: out of memory\n");
  const Outcome status = with_programs("--status");
  EXPECT_EQ(status.status, 3);
  EXPECT_THAT(status.out, HasSubstr("shard 3/3       0 of 16 runs, PENDING (Resources)\n"));
  EXPECT_THAT(status.out, HasSubstr("shard 1/3       0 of 16 runs, not begun; "
                                    "r/shards/slurm/1_of_3.txt ends with: slurmstepd: error: out"));
  expect_refused(with_programs("--slurm 4"),
                 "Slurm has 3 shards of this result in its queue already; say --slurm 3");

  for (const char* task : {"1", "3"}) {
    const Outcome done =
        shell(std::string("SLURM_ARRAY_TASK_ID=") + task + " sh r/shards/slurm/task_of_3.sh");
    EXPECT_EQ(done.status, 0) << done.err;
  }
  expect_as_on_one_machine();
}

}  // namespace
}  // namespace mapbed
