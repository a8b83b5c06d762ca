#include "bench/cli/run/run_told.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "bench/pages/reports.h"
#include "bench/process/folder_lock.h"
#include "bench/results/claim.h"
#include "bench/scenario/failed_runs.h"
#include "bench/shards/merging.h"

namespace mapbed {
namespace {

void print_claims(const Results& results) {
  for (const Verdict& claim : results.verdicts) {
    std::string verdict = text_of(claim, results.quick);
    if (verdict == "not held") verdict = "NOT HELD";
    fmt::print("{:<10} {}\n           {}\n", verdict, claim.claim, claim.measured);
  }
  if (results.quick && !results.verdicts.empty()) {
    fmt::print("remark: a quick run is no verdict on the claims; the run without --quick is\n");
  }
}

void print_result(const ScenarioRun& run, const std::string& folder) {
  const auto total = run.results.runs.size();
  const auto failed = std::count_if(run.results.runs.begin(), run.results.runs.end(),
                                    [](const RunRow& row) { return !row.failure.empty(); });
  fmt::print("{}: {} runs, {} of them failed; {} were done before, {} recordings made\n",
             run.results.id, total, failed, run.done_before, run.recordings);
  fmt::print("{}", failed_runs_text(run.results, folder));
  for (const std::string& line : run.results.skipped) {
    fmt::print("remark: {}; set MAPBED_DATA to the folder that holds it\n", line);
  }
  for (const std::string& remark : run.remarks) fmt::print("remark: {}\n", remark);
  print_claims(run.results);
  fmt::print("written to {0}; see {0}/report.html\n", folder);
}

bool all_held(const Results& results) {
  return std::all_of(results.verdicts.begin(), results.verdicts.end(),
                     [](const Verdict& claim) { return claim.held || !claim.judged; });
}

}  // namespace

int tell_interrupted(std::size_t done, std::size_t all) {
  std::fflush(stdout);  // what was told before comes before
  fmt::print(stderr, "mapbed: interrupted after {} of {} runs; start again to go on\n", done, all);
  return kInterrupted;
}

int tell_finished(const ScenarioRun& run, const std::string& folder, bool strict) {
  while_told("writing pages", [&] {
    const FolderLock lock(folder, kPatience);  // others that find all runs in tell it, too
    write_page(folder);
  });
  print_result(run, folder);
  return strict && !all_held(run.results) ? kClaimsNotHeld : kDone;
}

}  // namespace mapbed
