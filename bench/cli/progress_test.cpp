#include "bench/cli/progress.h"

#include <gtest/gtest.h>

namespace mapbed {
namespace {

TEST(ProgressLine, TellsTheRemainingTimeByTheSpeedSoFar) {
  EXPECT_EQ(progress_line("matching", 25, 100, 20.0, false),
            "matching: 25 of 100, 25 %, 1:00 left");
  EXPECT_EQ(progress_line("matching", 1, 101, 100.0, false),
            "matching: 1 of 101, 0 %, 2:46:40 left");
}

TEST(ProgressLine, KnowsNoRemainingTimeBeforeTheFirstStep) {
  EXPECT_EQ(progress_line("matching", 0, 100, 20.0, false), "matching: 0 of 100, 0 %");
}

TEST(ProgressLine, DrawsABarOfOneLengthForTerminals) {
  EXPECT_EQ(progress_line("matching", 50, 100, 1.0, true),
            "matching [###############...............]  50 %, 0:01 left");
  EXPECT_EQ(progress_line("matching", 100, 100, 1.0, true),
            "matching [##############################] 100 %, 0:00 left");
}

TEST(ProgressLine, NothingToDoIsDone) {
  EXPECT_EQ(progress_line("matching", 0, 0, 0.0, false), "matching: 0 of 0, 100 %, 0:00 left");
}

}  // namespace
}  // namespace mapbed
