#include "bench/shards/shard_run.h"

#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "bench/process/folder_lock.h"
#include "bench/scenario/testing/own_files.h"
#include "bench/shards/merging.h"
#include "bench/shards/shard_folders.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

const MayGoOn kToTheEnd = [](std::size_t, std::size_t) { return true; };
const MayGoOn kOneRun = [](std::size_t done, std::size_t) { return done < 1; };

// 8 runs on 2 recordings of a second.
class Shards : public OwnFiles {
 protected:
  Shards() { run(plan_, "whole"); }

  ShardRun shard(int index, int count, const MayGoOn& may_go_on = kToTheEnd,
                 bool restart = false) const {
    return shard_of(plan_, index, count, may_go_on, restart);
  }
  ShardRun shard_of(const ScenarioPlan& plan, int index, int count,
                    const MayGoOn& may_go_on = kToTheEnd, bool restart = false) const {
    fs::create_directories(path("r"));
    return run_shard(plan, {.folder = path("r"), .threads = 1, .restart = restart}, {index, count},
                     may_go_on);
  }
  ScenarioRun whole(bool restart = false) const {
    fs::create_directories(path("r"));
    return run_all_shards(plan_, {.folder = path("r"), .threads = 1, .restart = restart},
                          kToTheEnd);
  }
  void expect_as_on_one_machine() const { EXPECT_EQ(bytes_of("r"), bytes_of("whole")); }

  ScenarioPlan plan_ = planned(scenario("room.yaml"), {"seeds=2"});
};

TEST_F(Shards, InAnyOrderGiveTheBytesOfOneMachine) {
  for (const std::vector<int>& order : {std::vector{1, 2, 3}, {3, 1, 2}, {2, 3, 1}}) {
    fs::remove_all(path("r"));
    EXPECT_FALSE(shard(order[0], 3).merged);
    const ShardRun second = shard(order[1], 3);
    EXPECT_FALSE(second.merged);
    EXPECT_FALSE(fs::exists(path("r/config.yaml")));
    const ShardRun last = shard(order[2], 3);
    ASSERT_TRUE(last.merged);
    EXPECT_EQ(last.merged->results.runs.size(), 8u);
    EXPECT_EQ(second.in + last.done, 8);
    expect_as_on_one_machine();
  }
}

TEST_F(Shards, OneThatWasEndedGoesOnWhereItWas) {
  const ShardRun ended = shard(1, 2, kOneRun);
  EXPECT_EQ(ended.done, 1);
  EXPECT_FALSE(shard(2, 2).merged);
  const ShardRun again = shard(1, 2);
  EXPECT_EQ(again.done_before, 1);
  EXPECT_EQ(again.done, 3);
  EXPECT_TRUE(again.merged);
  expect_as_on_one_machine();
}

TEST_F(Shards, WhatIsLeftIsDoneByTheWholeScenario) {
  shard(1, 3);
  shard(2, 3, kOneRun);
  const ScenarioRun run = whole();
  EXPECT_GE(run.done_before, 3);
  expect_as_on_one_machine();
}

TEST_F(Shards, OfAnotherDivisionAreNotDoneAgain) {
  const int done = shard(1, 4).done;
  const ShardRun all = shard(1, 1);
  EXPECT_EQ(all.done_before, done);
  EXPECT_EQ(all.done, 8 - done);
  expect_as_on_one_machine();
}

TEST_F(Shards, OfWhatIsFinishedHaveNothingToDo) {
  whole();
  const ShardRun run = shard(2, 3);
  EXPECT_EQ(run.done, 0);
  EXPECT_TRUE(run.merged);
  EXPECT_INPUT_ERROR(shard(2, 3, kToTheEnd, true),
                     "/r: all runs of this result are done; --restart without --shard and --slurm");
  expect_as_on_one_machine();
}

TEST_F(Shards, OfAnotherSeedOrScenarioAreRefusedUnlessTheyAreThrownAway) {
  const ScenarioPlan other = planned(path("x.yaml"), {"seeds=2", "recorder.longest=2 s"});
  shard_of(other, 1, 2);
  EXPECT_INPUT_ERROR(shard(2, 2),
                     "r/shards/1_of_2/runs/journal: these runs are of another version of the "
                     "scenario, other settings or another seed; let all shards have the same");
  EXPECT_INPUT_ERROR(whole(), "another seed");
  EXPECT_FALSE(shard(2, 2, kToTheEnd, true).merged);
  EXPECT_TRUE(shard(1, 2).merged);
  expect_as_on_one_machine();
}

TEST_F(Shards, OfAnotherProgramAreRefused) {
  const std::string identity = identity_of_runs(plan_);
  fs::create_directories(path("r"));
  EXPECT_NO_THROW(refuse_other_runs(path("r"), identity));
  shard(1, 2);
  const std::string of_other_program = identity.substr(0, 64) + std::string(64, '0');
  EXPECT_INPUT_ERROR(refuse_other_runs(path("r"), of_other_program),
                     "these runs are of another version of the program");
}

TEST_F(Shards, AreInTheWayOfTheWholeScenarioWhileSomebodyIsAtWork) {
  shard(1, 2);
  {
    const FolderLock at_work(path("r/shards/1_of_2"));
    EXPECT_INPUT_ERROR(whole(), "r/shards/1_of_2: another run is at work on this shard");
    EXPECT_INPUT_ERROR(whole(true), "r/shards/1_of_2: another run is at work on this shard");
    EXPECT_FALSE(shard(2, 2).merged) << "left to the one that is at work";
  }
  whole(true);
  expect_as_on_one_machine();
}

}  // namespace
}  // namespace mapbed
