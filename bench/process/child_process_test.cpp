#include "bench/process/child_process.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/process/stopwatch.h"
#include "core/file/text_file.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

class ChildProcess : public ::testing::Test {
 protected:
  ChildCommand command(const std::vector<std::string>& words, double limit = 20.0) const {
    return {words, folder_.file("."), folder_.file("messages"), limit};
  }
  ChildCommand script(const std::string& text, double limit = 20.0) const {
    return command({"sh", "-c", text}, limit);
  }
  std::string text(const std::string& name) const { return read_text_file(folder_.file(name)); }
  // The process whose number the child wrote into a file is gone, to the last entry of the system.
  bool is_gone(const std::string& name) const {
    return kill(static_cast<pid_t>(std::stol(text(name))), 0) != 0;
  }
  std::string path(const std::string& name) const { return folder_.file(name); }

 private:
  TemporaryFolder folder_;
};

TEST_F(ChildProcess, TellsItsExitStatusAndKeepsWhatItSaid) {
  const ChildEnd end = run_child(script("echo out; echo err >&2; exit 3"));
  EXPECT_EQ(end.status, 3);
  EXPECT_FALSE(end.is_success());
  EXPECT_EQ(text("messages"), "out\nerr\n");
  EXPECT_EQ(text_of(end, 20.0), "ended with exit status 3");
}

TEST_F(ChildProcess, GetsItsArgumentsAsTheyAre) {
  const std::string odd = "a b; touch x $(touch y) 'q' \"p\" *";
  EXPECT_TRUE(run_child(command({"printf", "%s", odd})).is_success());
  EXPECT_EQ(text("messages"), odd);
  EXPECT_FALSE(std::filesystem::exists(path("x")) || std::filesystem::exists(path("y")));
}

TEST_F(ChildProcess, TellsTheSignalThatEndedIt) {
  const ChildEnd end = run_child(script("kill -SEGV $$"));
  EXPECT_EQ(end.signal, SIGSEGV);
  EXPECT_EQ(text_of(end, 20.0), "was ended by signal 11 (Segmentation fault)");
}

TEST_F(ChildProcess, TellsWhyItCannotBeStarted) {
  std::ofstream(path("text")) << "no program\n";
  std::filesystem::permissions(path("text"), std::filesystem::perms::owner_all);
  const ChildEnd end = run_child(command({path("text")}));
  EXPECT_EQ(text_of(end, 20.0), "cannot be started: Exec format error");
}

TEST_F(ChildProcess, ReadsNothingFromTheTerminal) {
  EXPECT_TRUE(run_child(script("! read line")).is_success());
}

TEST_F(ChildProcess, HasNoOpenFilesOfThisProgram) {
  const std::ofstream open_here(path("open"));
  run_child(script("ls -l /proc/self/fd"));
  EXPECT_THAT(text("messages"), ::testing::Not(HasSubstr(path("open"))));
  EXPECT_THAT(text("messages"), ::testing::Not(HasSubstr("pipe:")));
}

TEST_F(ChildProcess, IsEndedAtItsLimitWithAllThatItStarted) {
  // One child of the shell's own group, one that left it, and one whose parent is over.
  const ChildEnd end =
      run_child(script("sleep 100 & echo $! >a; setsid sleep 100 & echo $! >b;"
                       "(setsid sh -c 'echo $$ >c; sleep 100; true' &); sleep 0.05; sleep 100",
                       0.3));
  EXPECT_TRUE(end.timed_out);
  EXPECT_EQ(text_of(end, 0.3), "was ended after its limit of 0.3 s");
  EXPECT_LT(end.wall_seconds, 5.0);
  EXPECT_TRUE(is_gone("a") && is_gone("b") && is_gone("c"));
}

TEST_F(ChildProcess, LeavesNothingBehindWhereItEndsByItself) {
  EXPECT_TRUE(run_child(script("setsid sleep 100 & echo $! >a")).is_success());
  EXPECT_TRUE(is_gone("a"));
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a zombie of this program";
}

TEST_F(ChildProcess, IsEndedWhereThisProgramIsToldToStop) {
  int asked = 0;
  EXPECT_THROW(run_child(script("echo $$ >a; sleep 100; true"), [&] { return ++asked < 3; }),
               Interrupted);
  EXPECT_TRUE(is_gone("a"));
}

TEST_F(ChildProcess, IsEndedWhereThisProgramIsKilled) {
  std::filesystem::create_directory(path("left"));
  const pid_t program = fork();
  ASSERT_GE(program, 0);
  if (program == 0) {
    ChildCommand lasting = script("echo $$ >b; mv b a; sleep 100; true", 0.0);
    lasting.leftover = path("left");
    run_child(lasting);
    _exit(0);
  }
  const Stopwatch stopwatch;
  const auto wait_for = [&](const auto& happened) {
    while (!happened() && stopwatch.seconds() < 10.0) usleep(2000);
  };
  wait_for([&] { return std::filesystem::exists(path("a")); });
  kill(program, SIGKILL);
  waitpid(program, nullptr, 0);
  wait_for([&] { return is_gone("a") && !std::filesystem::exists(path("left")); });
  EXPECT_TRUE(is_gone("a"));
  EXPECT_FALSE(std::filesystem::exists(path("left")));
}

TEST_F(ChildProcess, SeveralAtATimeDoNotHoldEachOther) {
  std::atomic<bool> stop = false;
  std::thread lasting([&] {
    EXPECT_THROW(run_child(command({"sleep", "100"}), [&] { return !stop.load(); }), Interrupted);
  });
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(run_child(command({"true"})).is_success());
  stop = true;
  lasting.join();
}

TEST_F(ChildProcess, CostsWhatItsWholeFamilyNeeded) {
  // A shell that the first one starts and waits for starts one that fills a buffer, and
  // keeps it for long enough to be seen full.
  const ChildEnd end =
      run_child(script("sh -c 'dd if=/dev/zero of=/dev/null bs=200M count=10; true'; true"));
  ASSERT_TRUE(end.is_success());
  EXPECT_GT(end.peak_memory, 200e6);
  EXPECT_LT(end.peak_memory, 250e6);
  EXPECT_GT(end.processor_seconds, 0.01);
  EXPECT_GE(end.wall_seconds, 0.5 * end.processor_seconds);
}

TEST_F(ChildProcess, IsNotChargedWithTheMemoryOfThisProgram) {
  const std::vector<char> much(100'000'000, 'x');
  const ChildEnd end = run_child(script("sleep 0.1; true"));
  EXPECT_GT(end.peak_memory, 1e5);
  EXPECT_LT(end.peak_memory, 20e6) << much.size();
}

TEST_F(ChildProcess, IsLookedForInThePath) {
  EXPECT_THAT(program_in_path("sh"), ::testing::EndsWith("/sh"));
  EXPECT_EQ(program_in_path("no_such_program"), "");
  EXPECT_EQ(program_in_path(""), "");
  EXPECT_EQ(program_in_path(path("messages")), "");
}

}  // namespace
}  // namespace mapbed
