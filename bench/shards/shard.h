#pragma once

#include <string>
#include <vector>

namespace mapbed {

struct ScenarioPlan;

// The part of a scenario's runs that one of several programs does.
struct Shard {
  int index = 1;  // from 1
  int count = 1;  // of all shards

  friend bool operator==(const Shard&, const Shard&) = default;
};

constexpr int kMostShards = 1000;  // as many tasks as Slurm takes in an array by default

Shard parse_shard(const std::string& text);  // "3/8"; InputError
std::string text_of(const Shard& shard);     // the same back

// Numbers of its runs, the same wherever they are asked for. Each run is in one shard. Runs that
// share a recording stay together where there are at least as many recordings as shards. Of these
// parts, and of those of each level of the sweep, no shard has two more than another; those of a
// seed are spread as far as that leaves it open.
std::vector<int> runs_of(const ScenarioPlan& plan, const Shard& shard);
std::vector<std::vector<int>> runs_of_all(const ScenarioPlan& plan, int shards);

}  // namespace mapbed
