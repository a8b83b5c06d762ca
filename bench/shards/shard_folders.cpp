#include "bench/shards/shard_folders.h"

#include <algorithm>
#include <filesystem>
#include <tuple>

#include <fmt/format.h>

#include "bench/process/folder_lock.h"
#include "bench/scenario/journal.h"
#include "bench/scenario/plan.h"
#include "bench/scenario/staging_folder.h"
#include "core/file/parse_number.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

std::string journal_in(const std::string& folder, const std::string& staging) {
  return (fs::path(folder) / staging / "journal").string();
}

std::string identity_in(const std::string& folder, const std::string& staging) {
  return Journal::identity_of(journal_in(folder, staging));
}

// The staging folders of a result, its own first.
std::vector<std::string> stagings_in(const std::string& folder) {
  std::vector<std::string> stagings{StagingFolder::kStaging};
  for (const Shard& shard : shards_in(folder)) stagings.push_back(staging_of(shard));
  return stagings;
}

// A file or an empty folder. On file systems over a network files stay as long as a program has
// them open, and their folder with them; the next one that comes by removes it.
void try_remove(const fs::path& path) {
  std::error_code none;
  fs::remove(path, none);
}

// Nobody is at work on it.
void remove(const std::string& folder, const Shard& shard) {
  const fs::path path = fs::path(folder) / folder_of(shard);
  discard_staging(path.string(), identity_in(path.string(), StagingFolder::kStaging));
  try_remove(path / StagingFolder::kStaging);
  try_remove(path / ".lock");  // of a program that was killed
  try_remove(path);
}

void refuse_if_busy(const std::string& folder, const Shard& shard) {
  if (!is_busy(folder, shard)) return;
  throw InputError({(fs::path(folder) / folder_of(shard)).string()},
                   "another run is at work on this shard",
                   "wait for it to end, or choose another folder with --out");
}

// "3_of_8"; false for other names.
bool parse_name(const std::string& name, Shard& shard) {
  const std::size_t of = name.find("_of_");
  return of != std::string::npos && parse_number(name.substr(0, of), shard.index) &&
         parse_number(name.substr(of + 4), shard.count) && shard.index >= 1 &&
         shard.index <= shard.count && shard.count <= kMostShards;
}

// An identity is a checksum of the configuration and one of the program, of the same length.
bool is_of_other_configuration(const std::string& a, const std::string& b) {
  return a.substr(0, a.size() / 2) != b.substr(0, b.size() / 2);
}

}  // namespace

std::string folder_of(const Shard& shard) {
  return fmt::format("{}/{}_of_{}", kShards, shard.index, shard.count);
}

std::string staging_of(const Shard& shard) {
  return folder_of(shard) + "/" + StagingFolder::kStaging;
}

std::vector<Shard> shards_in(const std::string& folder) {
  std::vector<Shard> shards;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(fs::path(folder) / kShards, none)) {
    Shard shard;
    if (parse_name(entry.path().filename().string(), shard)) shards.push_back(shard);
  }
  std::sort(shards.begin(), shards.end(), [](const Shard& a, const Shard& b) {
    return std::tie(a.count, a.index) < std::tie(b.count, b.index);
  });
  return shards;
}

bool is_busy(const std::string& folder, const Shard& shard) {
  return FolderLock::is_taken((fs::path(folder) / folder_of(shard)).string());
}

bool is_any_busy(const std::string& folder) {
  const std::vector<Shard> shards = shards_in(folder);
  return std::any_of(shards.begin(), shards.end(),
                     [&](const Shard& shard) { return is_busy(folder, shard); });
}

void refuse_busy_shards(const std::string& folder) {
  for (const Shard& shard : shards_in(folder)) refuse_if_busy(folder, shard);
}

std::set<int> runs_in(const std::string& staging, const ScenarioPlan& plan) {
  std::set<int> runs;
  const auto journal = (fs::path(staging) / "journal").string();
  for (const Journal::Entry& entry : Journal::entries_of(journal, plan.results.metrics.size())) {
    runs.insert(entry.row.run);
  }
  return runs;
}

std::set<int> runs_in_all(const std::string& folder, const ScenarioPlan& plan) {
  std::set<int> runs;
  for (const std::string& staging : stagings_in(folder)) {
    runs.merge(runs_in((fs::path(folder) / staging).string(), plan));
  }
  return runs;
}

void refuse_other_runs(const std::string& folder, const std::string& identity) {
  for (const std::string& staging : stagings_in(folder)) {
    const std::string found = identity_in(folder, staging);
    if (found.empty() || found == identity) continue;
    const bool is_configuration = is_of_other_configuration(found, identity);
    throw InputError(
        {journal_in(folder, staging)},
        is_configuration ? "these runs are of another version of the scenario, other "
                           "settings or another seed"
                         : "these runs are of another version of the program",
        std::string(staging == StagingFolder::kStaging ? "" : "let all shards have the same; ") +
            "--restart throws these runs away, --out chooses another folder");
  }
}

void remove_other_runs(const std::string& folder, const std::string& identity) {
  for (const Shard& shard : shards_in(folder)) {
    const std::string found = identity_in(folder, staging_of(shard));
    if (found.empty() || found == identity) continue;
    refuse_if_busy(folder, shard);
    remove(folder, shard);
  }
  const std::string found = identity_in(folder, StagingFolder::kStaging);
  if (found != identity) discard_staging(folder, found);
}

void remove_shards(const std::string& folder) {
  refuse_busy_shards(folder);
  for (const Shard& shard : shards_in(folder)) remove(folder, shard);
  remove_unused(folder);
}

void discard_shards(const std::string& folder, const std::string& identity) {
  for (const Shard& shard : shards_in(folder)) {
    const std::string found = identity_in(folder, staging_of(shard));
    const bool is_in = found.empty() || found == identity;
    if (is_in && !is_busy(folder, shard)) remove(folder, shard);
  }
  remove_unused(folder);
}

void remove_unused(const std::string& folder) {
  for (const Shard& shard : shards_in(folder)) try_remove(fs::path(folder) / folder_of(shard));
  if (!shards_in(folder).empty()) return;
  std::error_code none;
  fs::remove_all(fs::path(folder) / kSlurmFiles, none);
  try_remove(fs::path(folder) / kShards);
}

}  // namespace mapbed
