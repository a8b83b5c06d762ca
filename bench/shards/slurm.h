#pragma once

#include <string>
#include <vector>

#include "bench/shards/shard.h"

namespace mapbed {

// Slurm as its programs sbatch and squeue have it, which are looked for in PATH. Nothing is asked
// of its accounting, which many clusters do not have.

// A task of an array job that does a shard.
struct QueuedShard {
  Shard shard;
  std::string state;  // "RUNNING", "PENDING (Resources)", …
};

struct ShardSubmission {
  std::string folder;                // of the results
  std::vector<Shard> shards = {};    // of one division
  std::vector<std::string> command;  // of a shard, without --shard
  int processors = 1;                // of each task
  std::vector<std::string> options;  // of sbatch
};

// The file with what the task of a shard prints, below the results' folder.
std::string messages_of(const Shard& shard);

// Submits an array job with a task for each shard. Gives the number of the job. Throws InputError
// with what sbatch says where it refuses, and where it is not there.
std::string submit_to_slurm(const ShardSubmission& submission);

// The tasks that do shards of the results in that folder, waiting or at work.
std::vector<QueuedShard> queued_in_slurm(const std::string& folder);

bool has_slurm();

// Throws InputError where an option is one that mapbed chooses itself.
void check_sbatch_options(const std::vector<std::string>& options);

}  // namespace mapbed
