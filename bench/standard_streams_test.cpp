#include "bench/process/standard_streams.h"

#include <filesystem>

#include "bench/cli/testing/command_test.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

using StandardStreams = CommandTest;

TEST_F(StandardStreams, AFullOneIsToldByEveryCommand) {
  write("path.tum", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n2 2 0 0 0 0 0 1\n");
  for (const char* command :
       {"list", "describe rbpf", "--help", "run --help", "--version", "",
        "evaluate path.tum --truth path.tum", "map example --set log.longest='3 s' --out m",
        "simulate --world office --robot pioneer --set recorder.longest='1 s' -o drive.log",
        "render m/map.yaml -o p.png",
        "run ch2_raw_odometry --set recorder.longest='1 s' --run 0"}) {
    const Outcome outcome = run_shell(std::string("$MAPBED ") + command + " >/dev/full", path());
    EXPECT_EQ(outcome.status, 1) << command;
    EXPECT_THAT(outcome.err, HasSubstr("mapbed: standard output cannot be written completely"))
        << command;
  }
}

TEST_F(StandardStreams, AClosedOneIsToldAndItsWordsGetIntoNoFile) {
  const Outcome outcome = run_shell(
      "$MAPBED simulate --world office --robot pioneer --set recorder.longest='1 s' -o drive.log "
      ">&- <&-",
      path());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("Bad file descriptor"));
  EXPECT_THAT(text("drive.log"), ::testing::Not(HasSubstr("times real time")));
  EXPECT_EQ(run_shell("$MAPBED list 2>&-", path()).status, 0);
}

}  // namespace
}  // namespace mapbed
