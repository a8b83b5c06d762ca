#pragma once

#include <optional>
#include <string>

#include "bench/scenario/run_scenario.h"

namespace mapbed {

// What programs that work on one result at the same time agree on: who does a shard has its lock as
// long, and takes it with the lock of the result's folder in hand, which it then lets go. So who
// has the result's, and finds that of a shard free, knows that nobody begins with it meanwhile.

// [s] that a program waits for a lock. One that was ended elsewhere may have its own for a moment.
constexpr double kPatience = 60.0;

// Whether the folder has the result of this plan and program.
bool is_finished(const ScenarioPlan& plan, const std::string& folder);

// Sees that shards may work in the folder, which is locked; what is in the way of other
// configurations goes where `restart`. Throws InputError where it may not.
void check_folder(const ScenarioPlan& plan, const ScenarioRunOptions& options);

// The result that is_finished, with the words of this plan. The folder is locked. Throws InputError
// where `restart`: that is for all runs at once.
ScenarioRun finished_result(const ScenarioPlan& plan, const ScenarioRunOptions& options,
                            const MayGoOn& may_go_on);

// Merges where nothing is missing any more, and nobody is at work, who would merge in the end. The
// caller has no lock.
std::optional<ScenarioRun> merge_if_all_in(const ScenarioPlan& plan,
                                           const ScenarioRunOptions& options,
                                           const MayGoOn& may_go_on);

// Does all runs, but for those that shards have done, as run_scenario. Throws InputError where a
// program is at work on a shard.
ScenarioRun run_all_shards(const ScenarioPlan& plan, const ScenarioRunOptions& options,
                           const MayGoOn& may_go_on);

}  // namespace mapbed
