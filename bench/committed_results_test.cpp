// The results in results/ are those of the program of today: the cheapest run of each variant is
// done again, and its row is the same to the last digit. Skipped where the log is not here, and on
// processors without fused multiply-add, for which the same bytes are not promised.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <ostream>
#include <string>

#include <gmock/gmock.h>

#include "bench/process/thread_limit.h"
#include "bench/results/result_folder.h"
#include "bench/scenario/plan.h"
#include "bench/scenario/runner.h"
#include "bench/scenario/scenario.h"
#include "core/check.h"
#include "core/file/csv_file.h"
#include "core/input_error.h"
#include "core/testing/source_tree.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

constexpr double kEnough = 2.6;  // [s] of processor time that the runs of a scenario took

std::vector<std::string> committed_results() {
  std::vector<std::string> names;
  for (const std::string& folder : result_folders(source_tree() + "/results")) {
    names.push_back(fs::path(folder).filename().string());
  }
  return names;
}

// Runs with the same seed and level mostly share a recording.
using Place = std::pair<std::uint64_t, int>;

// [s] of processor time that each recording took. The one of a level is told with the first run
// that needed it, which may be one of another level.
std::map<Place, double> recording_costs(const Results& results) {
  std::map<Place, double> by_place;
  std::map<std::uint64_t, double> by_seed;
  for (std::size_t i = 0; i < results.runs.size(); ++i) {
    const RunRow& row = results.runs[i];
    double& of_place = by_place[{row.seed, row.level}];
    of_place = std::max(of_place, results.costs.at(i).recording_seconds);
    by_seed[row.seed] = std::max(by_seed[row.seed], of_place);
  }
  for (auto& [place, seconds] : by_place) {
    if (seconds == 0.0) seconds = by_seed[place.first];
  }
  return by_place;
}

// Where a run with its recording is cheapest, the run of each variant, the cheapest first, as many
// as are done in kEnough, but one at least.
std::vector<int> cheap_runs(const Results& results) {
  const std::map<Place, double> recordings = recording_costs(results);
  std::map<Place, std::vector<CostRow>> by_place;
  for (std::size_t i = 0; i < results.runs.size(); ++i) {
    by_place[{results.runs[i].seed, results.runs[i].level}].push_back(results.costs.at(i));
  }
  const std::vector<CostRow>* cheapest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (auto& [place, costs] : by_place) {
    std::sort(costs.begin(), costs.end(),
              [](const CostRow& a, const CostRow& b) { return a.seconds < b.seconds; });
    const double seconds = recordings.at(place) + costs.front().seconds;
    if (seconds >= least) continue;
    least = seconds;
    cheapest = &costs;
  }
  std::vector<int> chosen;
  double seconds = 0.0;
  for (const CostRow& cost : *cheapest) {
    seconds += cost.seconds;
    if (!chosen.empty() && seconds > kEnough) break;
    chosen.push_back(cost.run);
  }
  return chosen;
}

// By the names of columns, as runs.csv has them: a difference is told in the words of the table.
std::map<std::string, std::string> fields_of(const Results& results, const RunRow& row) {
  std::map<std::string, std::string> fields{{"seed", std::to_string(row.seed)},
                                            {"level", level_text(results, row.level)},
                                            {"variant", run_words(results, row)},
                                            {"failure", row.failure}};
  for (std::size_t i = 0; i < results.metrics.size(); ++i) {
    fields[results.metrics[i].name] = csv_number(row.values.at(i));
  }
  return fields;
}

// None where all its logs are elsewhere, or a program that is a method is not installed.
std::optional<ScenarioPlan> plan_of(const std::string& scenario) {
  try {
    return make_plan(load_scenario(scenario));
  } catch (const InputError& error) {
    const std::string reason = error.what();
    const bool is_without_logs = std::getenv("MAPBED_DATA") == nullptr;
    if (is_without_logs && reason.find("set MAPBED_DATA") != std::string::npos) return {};
    if (reason.find("; apt-get install ") != std::string::npos) return {};
    throw;
  }
}

// Of the run of that number; those that were not to be done have no row.
const RunRow& row_of(const Results& results, int run) {
  const auto found = std::find_if(results.runs.begin(), results.runs.end(),
                                  [run](const RunRow& row) { return row.run == run; });
  CHECK(found != results.runs.end());
  return *found;
}

class CommittedResult : public ::testing::TestWithParam<std::string> {};

TEST_P(CommittedResult, IsThatOfTheProgramOfToday) {
  if (__builtin_cpu_supports("fma") == 0) GTEST_SKIP() << "no fused multiply-add";
  const Results committed = load_results(source_tree() + "/results/" + GetParam());
  const std::optional<ScenarioPlan> planned = plan_of(GetParam());
  if (!planned) GTEST_SKIP() << "its logs or programs are not there";
  const ScenarioPlan& plan = *planned;
  const std::vector<int> runs = cheap_runs(committed);
  ASSERT_FALSE(runs.empty());
  ASSERT_EQ(plan.runs_to_do().size(), committed.runs.size());
  for (const int run : runs) {
    const std::string missing = plan.planned_of(plan.row(run)).missing();
    if (!missing.empty()) GTEST_SKIP() << missing;
  }
  std::map<int, RunRow> today;
  const RunnerCalls calls{[&today](RunResult result) { today[result.row.run] = result.row; },
                          [] { return true; }};
  do_runs(plan, runs, processors(), calls);
  for (const int run : runs) {
    SCOPED_TRACE(GetParam() + ", run " + std::to_string(run));
    EXPECT_EQ(fields_of(plan.results, today.at(run)), fields_of(committed, row_of(committed, run)));
  }
}

INSTANTIATE_TEST_SUITE_P(Results, CommittedResult, ::testing::ValuesIn(committed_results()),
                         [](const auto& result) { return result.param; });

}  // namespace
}  // namespace mapbed
