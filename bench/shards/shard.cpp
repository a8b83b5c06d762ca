#include "bench/shards/shard.h"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include "bench/scenario/plan.h"
#include "bench/scenario/runner.h"
#include "core/check.h"
#include "core/file/parse_number.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

// What is not divided.
struct RunsTogether {
  std::vector<int> runs;
  int level = 0;  // of the first of them
  std::uint64_t seed = 0;
};

RunsTogether part_of(const ScenarioPlan& plan, std::vector<int> runs) {
  const RunRow first = plan.row(runs.front());
  return {std::move(runs), first.level, first.seed};
}

// Runs on one log that is the same for all seeds share nothing that is worth waiting for.
bool has_recordings(const ScenarioPlan& plan) {
  return std::any_of(plan.planned.begin(), plan.planned.end(), [](const PlannedRuns& runs) {
    return std::any_of(runs.sources.begin(), runs.sources.end(),
                       [](const auto& source) { return source->depends_on_seed; });
  });
}

// By level, and within it by seed and variant.
std::vector<RunsTogether> parts_of(const ScenarioPlan& plan, int shards) {
  const std::vector<int> runs = plan.runs_to_do();
  std::vector<std::vector<int>> divided;
  if (has_recordings(plan)) divided = sharing_recordings(plan, runs);
  if (divided.size() < static_cast<std::size_t>(shards)) {
    divided.clear();
    for (const int run : runs) divided.push_back({run});
  }
  std::vector<RunsTogether> parts;
  for (std::vector<int>& of_part : divided) parts.push_back(part_of(plan, std::move(of_part)));
  std::stable_sort(parts.begin(), parts.end(),
                   [](const RunsTogether& a, const RunsTogether& b) { return a.level < b.level; });
  return parts;
}

}  // namespace

Shard parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  Shard shard;
  const bool is_read = slash != std::string::npos &&
                       parse_number(text.substr(0, slash), shard.index) &&
                       parse_number(text.substr(slash + 1), shard.count);
  if (is_read && shard.index >= 1 && shard.index <= shard.count && shard.count <= kMostShards) {
    return shard;
  }
  throw InputError({}, in_quotes(text) + " is no shard",
                   fmt::format("--shard 3/8 is the third of eight; at most {}", kMostShards));
}

std::string text_of(const Shard& shard) {
  return fmt::format("{}/{}", shard.index, shard.count);
}

// Each part goes to the shard that has the fewest of its level; among these the fewest in all;
// among these the fewest of its seed. Within a level this goes round all shards before it comes to
// one again, and begins each round with those that have less, so that totals never differ by two.
std::vector<std::vector<int>> runs_of_all(const ScenarioPlan& plan, int shards) {
  struct Load {
    int of_level = 0;  // parts of the level that is dealt out
    int all = 0;
    std::vector<int> of_seed = {};
    std::vector<int> runs = {};
  };
  const auto seeds = static_cast<std::size_t>(plan.scenario.seeds);
  std::vector<Load> loads(static_cast<std::size_t>(shards));
  for (Load& load : loads) load.of_seed.resize(seeds);
  int level = 0;
  for (const RunsTogether& part : parts_of(plan, shards)) {
    if (part.level != level) {
      for (Load& load : loads) load.of_level = 0;
      level = part.level;
    }
    const auto seed = static_cast<std::size_t>(part.seed - plan.scenario.seed);
    const auto has_less = [seed](const Load& a, const Load& b) {
      return std::tie(a.of_level, a.all, a.of_seed[seed]) <
             std::tie(b.of_level, b.all, b.of_seed[seed]);
    };
    Load& least = *std::min_element(loads.begin(), loads.end(), has_less);
    ++least.of_level;
    ++least.all;
    ++least.of_seed[seed];
    least.runs.insert(least.runs.end(), part.runs.begin(), part.runs.end());
  }
  std::vector<std::vector<int>> all;
  for (Load& load : loads) {
    std::sort(load.runs.begin(), load.runs.end());
    all.push_back(std::move(load.runs));
  }
  return all;
}

std::vector<int> runs_of(const ScenarioPlan& plan, const Shard& shard) {
  CHECK(shard.index >= 1 && shard.index <= shard.count);
  return std::move(runs_of_all(plan, shard.count)[static_cast<std::size_t>(shard.index - 1)]);
}

}  // namespace mapbed
