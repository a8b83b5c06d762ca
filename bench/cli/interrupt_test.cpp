#include "bench/cli/interrupt.h"

#include <filesystem>

#include "bench/cli/testing/command_test.h"

namespace mapbed {
namespace {

// A pipe that nobody writes into: the first Ctrl-C has to end what waits for it.
TEST(Interrupt, IsHeededWhileALogIsWaitedFor) {
  const TemporaryFolder folder;
  const Outcome outcome = run_shell(
      "mkfifo log; exec 3<>log; $MAPBED map log --out m 3>&- & p=$!\n"
      "until ls -l /proc/$p/fd | grep -q '/log$' && grep -q '^State:.S' /proc/$p/status; do "
      "sleep 0.01; done\n"
      "kill -TERM $p; (sleep 5; kill -KILL $p) & late=$!; wait $p; s=$?; kill $late; exit $s",
      folder.file("."));
  EXPECT_EQ(outcome.status, 128 + 15);
  EXPECT_FALSE(std::filesystem::exists(folder.file("m")));
}

// The second log takes long to read: an interruption meanwhile leaves it, and keeps the first run.
TEST(Interrupt, IsHeededWhileARunReadsItsLog) {
  const TemporaryFolder folder;
  const Outcome outcome = run_shell(
      "$MAPBED simulate --world corridor --robot pioneer --people 0 "
      "--set 'recorder.longest=2 s' -o a.log\n"
      "(cat a.log; yes '# nothing is said here, and slowly' | head -c 100000000) | gzip -1 "
      "> b.log.gz\n"
      "printf 'about: two logs\nmetrics: [path_length]\nestimator: odometry\n"
      "compare: {a: {log: ./a.log}, b: {log: ./b.log.gz}}' > x.yaml\n"
      "$MAPBED run ./x.yaml -j 1 --out r & p=$!\n"
      "for i in $(seq 2000); do\n"
      "[ \"$(grep -c . r/runs/journal)\" = 2 ] && ls -l /proc/$p/fd | grep -q b.log && break\n"
      "sleep 0.005; done\n"
      "kill -TERM $p; wait $p",
      folder.file("."));
  EXPECT_EQ(outcome.status, 3);
  EXPECT_THAT(outcome.err, testing::HasSubstr("mapbed: interrupted after 1 of 2 runs"));
  const Outcome again = run_mapbed({"run", "./x.yaml", "--out", "r"}, folder.file("."));
  EXPECT_THAT(again.out, testing::HasSubstr("2 runs, 0 of them failed; 1 were done before"));
}

}  // namespace
}  // namespace mapbed
