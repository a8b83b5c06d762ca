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

}  // namespace
}  // namespace mapbed
