#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "bench/results/results.h"
#include "bench/scenario/plan.h"
#include "core/interrupted.h"

namespace mapbed {

class RunViewer;
struct RunResult;
class StagingFolder;

struct ScenarioRunOptions {
  std::string folder;  // of the results; exists
  int threads = 1;
  bool restart = false;                   // unfinished runs of before are thrown away
  std::vector<std::string> command = {};  // as it was given, for the provenance
  // Staging folders below the folder, whose runs, done by other programs, are taken over. They are
  // of this plan and program, and nobody writes there.
  std::vector<std::string> taken_over = {};
};

struct ScenarioRun {
  Results results;
  int done_before = 0;               // runs that an earlier start had done
  int recordings = 0;                // made now
  std::vector<std::string> remarks;  // on recordings that were made now
  bool complete = false;             // false: interrupted; nothing but the journal was written
};

// Asked often, by one thread at a time, with the runs that are done and all that there are; false
// ends the work with the runs that are under way. A log that is being recorded or read is left.
using MayGoOn = std::function<bool(std::size_t done, std::size_t total)>;

// Runs what is not done yet, evaluates the claims, and writes:
//
//   config.yaml; runs, summary, series, claims, files  the same bytes for the same seed
//   cost.csv, cost_claims.csv, provenance.json         all that differs from run to run
//   figures/                                           of the scenario's plots
//   maps/, trajectories/, graphs/, figures/, replays/  of the first seed, by level and variant
//
// Until everything is done it writes below runs/ only, and goes on from there when it is started
// again. An older result of the folder, of whatever configuration, stays until then; then the new
// one takes its place, with nothing left of it. Unfinished runs of another configuration are in the
// way unless this one is finished already. Throws InputError where another program is at work in
// the folder, or it cannot be written, or a finished result is not as it was written.
ScenarioRun run_scenario(const ScenarioPlan& plan, const ScenarioRunOptions& options,
                         const MayGoOn& may_go_on);

// The same in a folder that is locked by the caller.
ScenarioRun run_locked_scenario(const ScenarioPlan& plan, const ScenarioRunOptions& options,
                                const MayGoOn& may_go_on);

// Does those of the runs of these numbers that are not in the staging folder yet; complete where
// all are then. The results have rows and costs alone.
ScenarioRun staged_runs(const ScenarioPlan& plan, const std::vector<int>& runs, int threads,
                        StagingFolder& staging, const MayGoOn& may_go_on);

// One word for configuration and program: runs that agree in it are of one result.
std::string identity_of_runs(const ScenarioPlan& plan);

struct RepeatOptions {
  int threads = 1;
  RunViewer* viewer = nullptr;  // looks at the run's method at work
  GoesOn goes_on = {};
};

// One run alone, with all the files that the first seed's runs have, and its map for map servers;
// nothing is written. Throws Interrupted where it is not to go on, or the viewer ends it.
RunResult repeat_run(const ScenarioPlan& plan, int run, const RepeatOptions& options = {});

}  // namespace mapbed
