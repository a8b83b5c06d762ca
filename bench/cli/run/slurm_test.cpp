// Shards of a scenario as an array job of a real Slurm, of one node, that is started here: munged,
// slurmctld and slurmd in a folder of their own, with ports of their own. As root; skipped where
// the packages slurm-wlm and munge are missing.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include "bench/cli/testing/shard_command_test.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

namespace fs = std::filesystem;

constexpr int kSeeds = 150;  // 600 runs

constexpr const char* kSlurm =
    "ClusterName=test\n"
    "SlurmctldHost={host}(127.0.0.1)\n"
    "SlurmctldPort={controller_port}\n"
    "SlurmdPort={node_port}\n"
    "SlurmUser=root\n"
    "AuthInfo=socket={folder}/munge/socket,cred_expire=5\n"
    "AuthType=auth/munge\n"
    "CredType=cred/munge\n"
    "StateSaveLocation={folder}/state\n"
    "SlurmdSpoolDir={folder}/spool\n"
    "SlurmctldPidFile={folder}/slurmctld.pid\n"
    "SlurmdPidFile={folder}/slurmd.pid\n"
    "SlurmctldLogFile={folder}/slurmctld.log\n"
    "SlurmdLogFile={folder}/slurmd.log\n"
    "ProctrackType=proctrack/pgid\n"
    "TaskPlugin=task/none\n"
    "SelectType=select/cons_tres\n"
    "SelectTypeParameters=CR_CPU\n"
    "SlurmdParameters=config_overrides\n"
    "ReturnToService=2\n"
    "SchedulerParameters=sched_interval=1,sched_min_interval=100000,batch_sched_delay=0\n"
    "MailProg=/bin/true\n"
    "KillWait=2\n"
    "NodeName={host} NodeAddr=127.0.0.1 CPUs=4 State=UNKNOWN\n"
    "PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP\n";

class Slurm : public ShardCommand {
 protected:
  Slurm() : ShardCommand(kSeeds) {}

  void SetUp() override {
    if (geteuid() != 0) GTEST_SKIP() << "Slurm's daemons are started as root only";
    for (const char* program : {"sbatch", "squeue", "scontrol", "slurmctld", "slurmd", "munged"}) {
      if (shell(fmt::format("PATH=$PATH:/usr/sbin command -v {}", program)).status == 0) continue;
      GTEST_SKIP() << "there is no " << program << "; install slurm-wlm and munge";
    }
    start();
  }
  void TearDown() override {
    unsetenv("SLURM_CONF");
    if (slurm_.empty()) return;
    shell(
        fmt::format("cd {}; export SLURM_CONF=$PWD/slurm.conf\n"
                    "[ -e slurmctld.pid ] && scancel --me\n"
                    "for p in slurmd slurmctld munged; do [ -e $p.pid ] || continue\n"
                    "  n=$(cat $p.pid); kill $n\n"
                    "  for i in $(seq 300); do kill -0 $n 2> /dev/null || break; sleep 0.1; done\n"
                    "done",
                    slurm_));
    fs::remove_all(slurm_);
  }

  void start() {
    std::string made = "/tmp/mapbed_slurm_XXXXXX";  // short: a socket's name has 107 letters
    ASSERT_NE(mkdtemp(made.data()), nullptr);
    slurm_ = made;
    for (const char* name : {"state", "spool", "munge"}) fs::create_directory(made + "/" + name);
    fs::permissions(made, fs::perms(0755));
    fs::permissions(made + "/munge", fs::perms(0711));
    const std::string host = shell("hostname -s | tr -d '\\n'").out;
    const int port = 20'000 + 2 * (getpid() % 6'000);  // below those that the system gives away
    std::ofstream(made + "/slurm.conf") << fmt::format(
        fmt::runtime(kSlurm), fmt::arg("host", host), fmt::arg("controller_port", port),
        fmt::arg("node_port", port + 1), fmt::arg("folder", made));
    setenv("SLURM_CONF", (made + "/slurm.conf").c_str(), 1);
    const Outcome started =
        shell("set -e; PATH=$PATH:/usr/sbin; cd " + made +
              "\n"
              "head -c 128 /dev/urandom > munge.key; chmod 600 munge.key\n"
              "munged --force --num-threads=1 --key-file=$PWD/munge.key --socket=$PWD/munge/socket"
              " --pid-file=$PWD/munged.pid --log-file=$PWD/munged.log --seed-file=$PWD/munge.seed\n"
              "slurmctld -c; slurmd\n"
              "for i in $(seq 600); do sinfo -h -o %t | grep -q idle && exit 0; sleep 0.1; done\n"
              "tail -n 5 slurmctld.log slurmd.log; exit 1");
    ASSERT_EQ(started.status, 0) << started.out << started.err;
  }

  // Waits until the second task has been held so many times; gives what its journal has by then.
  std::string journal_when_held(int times) const {
    const auto held = [&] {
      if (!exists("held_2")) return 0;
      const std::string lines = text("held_2");
      return static_cast<int>(std::count(lines.begin(), lines.end(), '\n'));
    };
    EXPECT_TRUE(comes_true([&] { return held() == times; })) << run({"--status"}).out;
    return text("r/shards/2_of_4/runs/journal");
  }
  // Of the second task, in a form of squeue.
  static std::string id(const std::string& form) {
    return "$(squeue --noheader --array -o '" + form + " %K' | sed -n 's/ 2$//p')";
  }
  bool status_has(const std::string& words) const {
    return comes_true([&] { return run({"--status"}).out.find(words) != std::string::npos; });
  }

  std::string slurm_;  // folder of the daemons
};

TEST_F(Slurm, AnArrayJobWithATaskKilledTwiceGivesTheTablesOfOneMachine) {
  write("hold_2", "");
  const Outcome submitted = run({"--slurm", "4", "--", "--partition=all", "--time=5"});
  ASSERT_EQ(submitted.status, 0) << submitted.err;
  EXPECT_THAT(submitted.out, HasSubstr("shard 3/4       0 of 148 runs, submitted\n"));
  EXPECT_THAT(submitted.out, HasSubstr("submitted as job "));

  const std::string before = journal_when_held(1);
  EXPECT_GT(std::count(before.begin(), before.end(), '\n'), 1) << "runs are in, behind the head";
  EXPECT_THAT(run({"--status"}).out, HasSubstr(" of 152 runs, RUNNING\n"));
  expect_refused(run({"--slurm", "3"}), "say --slurm 4, or end them with scancel");
  const Outcome killed = shell("kill -KILL $(scontrol listpids " + id("%A") +
                               " | awk 'NR == 2 {print $1}')");  // the batch step: the program
  ASSERT_EQ(killed.status, 0) << killed.err;
  ASSERT_TRUE(status_has(" of 152 runs, stopped\n"));
  EXPECT_EQ(text("r/shards/2_of_4/runs/journal"), before);

  const Outcome again = run({"--slurm", "4", "--", "--time=5"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_THAT(again.out, ::testing::ContainsRegex("shard 2/4 .* of 152 runs, submitted\n"));
  EXPECT_THAT(journal_when_held(2), ::testing::StartsWith(before)) << "nothing of it is lost";
  const Outcome requeued = shell("scontrol requeue " + id("%i"));
  EXPECT_EQ(requeued.status, 0) << requeued.err;
  EXPECT_THAT(journal_when_held(3), ::testing::StartsWith(before));
  fs::remove(path("hold_2"));
  ASSERT_TRUE(status_has("sweep: 600 runs, 0 of them failed"));
  expect_as_on_one_machine();
}

TEST_F(Slurm, WhatItRefusesIsTold) {
  expect_refused(run({"--slurm", "4", "--", "--partition=none"}),
                 "sbatch: ended with exit status 1: sbatch: error: invalid partition specified");
  EXPECT_FALSE(exists("r"));
}

}  // namespace
}  // namespace mapbed
