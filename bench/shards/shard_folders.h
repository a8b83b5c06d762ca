#pragma once

#include <set>
#include <string>
#include <vector>

#include "bench/shards/shard.h"

namespace mapbed {

struct ScenarioPlan;

// Where shards work until all runs of a result are done: shards/3_of_8/ below its folder, which the
// program that does the shard has locked, with a staging folder runs/ inside. What is written there
// is of one configuration and program, as what is in the result's own staging folder.

constexpr const char* kShards = "shards";

std::string folder_of(const Shard& shard);   // below the result's folder
std::string staging_of(const Shard& shard);  // the same

// What tasks of Slurm need and say, below the result's folder.
constexpr const char* kSlurmFiles = "shards/slurm";

// Those that have a folder, in the order of count and index.
std::vector<Shard> shards_in(const std::string& folder);

// Whether a program is at work on that one, or on any of them.
bool is_busy(const std::string& folder, const Shard& shard);
bool is_any_busy(const std::string& folder);
void refuse_busy_shards(const std::string& folder);  // throws InputError where one is

// Runs that stand in the journal of a staging folder; somebody may be writing on.
std::set<int> runs_in(const std::string& staging, const ScenarioPlan& plan);

// The same for all staging folders of a result.
std::set<int> runs_in_all(const std::string& folder, const ScenarioPlan& plan);

// Throws InputError where a staging folder holds runs of another identity.
void refuse_other_runs(const std::string& folder, const std::string& identity);

// Throws away what has been staged of other identities, or by any shard. The result's folder is
// locked. Throws InputError where a program is at work on one of these shards.
void remove_other_runs(const std::string& folder, const std::string& identity);
void remove_shards(const std::string& folder);

// The shards of this identity, whose runs are in the result, go; not those somebody is at work on.
void discard_shards(const std::string& folder, const std::string& identity);

// Folders of shards that have not begun go; without any, nothing of Slurm's is needed either.
void remove_unused(const std::string& folder);

}  // namespace mapbed
