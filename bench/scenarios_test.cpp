// Every scenario with --quick: it runs, and its claims are reported.

#include <cstdlib>

#include <gmock/gmock.h>

#include "bench/cli/program_under_test.h"
#include "bench/results/result_folder.h"
#include "core/data_path.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {
namespace {

class QuickScenario : public ::testing::TestWithParam<std::string> {};

TEST_P(QuickScenario, RunsAndReportsItsClaims) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_mapbed({"run", GetParam(), "--quick", "--out", "r"}, folder.file("."));
  if (outcome.status == 1 && std::getenv("MAPBED_DATA") == nullptr &&
      outcome.err.find("set MAPBED_DATA") != std::string::npos) {
    GTEST_SKIP() << outcome.err;  // a scenario of recorded logs alone
  }
  if (outcome.status == 1 && outcome.err.find("; apt-get install ") != std::string::npos) {
    GTEST_SKIP() << outcome.err;  // a program of somebody else's that is not installed
  }
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Results results = load_results(folder.file("r"));
  EXPECT_FALSE(results.verdicts.empty());
  for (const Verdict& verdict : results.verdicts) EXPECT_FALSE(verdict.measured.empty());
}

INSTANTIATE_TEST_SUITE_P(Scenarios, QuickScenario, ::testing::ValuesIn(data_names("scenarios")),
                         [](const auto& scenario) { return scenario.param; });

}  // namespace
}  // namespace mapbed
