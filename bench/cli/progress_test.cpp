#include "bench/cli/progress.h"

#include <chrono>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

namespace mapbed {
namespace {

TEST(ProgressLine, TellsTheRemainingTimeByTheSpeedSoFar) {
  EXPECT_EQ(progress_line("matching", 25, 100, 20.0, false),
            "matching: 25 of 100, 25 %, 1:00 left");
  EXPECT_EQ(progress_line("matching", 1, 101, 100.0, false),
            "matching: 1 of 101, 0 %, 2:46:40 left");
}

TEST(ProgressLine, KnowsNoRemainingTimeBeforeTheFirstStepAndAfterTheLast) {
  EXPECT_EQ(progress_line("matching", 0, 100, 20.0, false), "matching: 0 of 100, 0 %, 0:20 so far");
  EXPECT_EQ(progress_line("matching", 100, 100, 80.0, false),
            "matching: 100 of 100, 100 %, 1:20 so far");
  EXPECT_EQ(progress_line("simulating", 0, {}, 20.0, false), "simulating: 0:20 so far");
}

TEST(ProgressLine, DrawsABarOfOneLengthForTerminals) {
  EXPECT_EQ(progress_line("matching", 50, 100, 1.0, true),
            "matching [###############...............]  50 %, 0:01 left");
  EXPECT_EQ(progress_line("matching", 100, 100, 1.0, true),
            "matching [##############################] 100 %, 0:01 so far");
}

TEST(ProgressLine, NothingToDoIsDone) {
  EXPECT_EQ(progress_line("matching", 0, 0, 0.0, false), "matching: 0 of 0, 100 %, 0:00 so far");
}

// However long one step takes; a line is due every 10 ms here.
TEST(Progress, SaysAWordWhileNothingAdvances) {
  ::testing::internal::CaptureStderr();
  {
    const Progress progress("matching", 100, 0.01);
    for (int i = 0; i < 1000 && lseek(STDERR_FILENO, 0, SEEK_CUR) == 0; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  EXPECT_NE(::testing::internal::GetCapturedStderr().find("matching"), std::string::npos);
}

TEST(Progress, SaysNothingAboutWhatTakesNoTime) {
  ::testing::internal::CaptureStderr();
  { Progress("matching", 100).advance_to(100); }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace mapbed
