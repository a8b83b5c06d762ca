#include "bench/scenario/failed_runs.h"

#include <gmock/gmock.h>

#include "bench/results/results.h"

namespace mapbed {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

Results results_of(const std::vector<std::string>& failures) {
  Results results;
  for (const std::string& failure : failures) {
    RunRow row;
    row.run = static_cast<int>(results.runs.size());
    row.failure = failure;
    results.runs.push_back(row);
  }
  return results;
}

TEST(FailedRuns, AreCountedByReasonWhateverNumbersItHas) {
  const Results results =
      results_of({"", "the program ended with status 3", "12.5 m off in the end",
                  "7 m off in the end", "", "103.25 m off in the end"});
  EXPECT_THAT(failed_runs_text(results, "results/x"),
              AllOf(HasSubstr("     3 x 12.5 m off in the end (run 2)\n"),
                    HasSubstr("     1 x the program ended with status 3 (run 1)\n"),
                    HasSubstr("results/x/runs.csv, column failure"), Not(HasSubstr("messages"))));
}

TEST(FailedRuns, OfManyReasonsTheMostFrequentAreTold) {
  Results results = results_of({"a", "b", "c", "d", "e", "f", "g", "g"});
  results.files.push_back({"messages/run_1.txt", 1, ""});
  EXPECT_THAT(failed_runs_text(results, "r"),
              AllOf(HasSubstr("     2 x g (run 6)\n     1 x a (run 0)\n"), HasSubstr("and 2 more"),
                    HasSubstr("r/messages")));
}

TEST(FailedRuns, WhereNoneFailedThereIsNothingToTell) {
  EXPECT_EQ(failed_runs_text(results_of({"", ""}), "r"), "");
}

}  // namespace
}  // namespace mapbed
