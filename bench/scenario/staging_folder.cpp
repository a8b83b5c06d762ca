#include "bench/scenario/staging_folder.h"

#include <fstream>
#include <iterator>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/process/foreign_files.h"
#include "bench/results/result_folder.h"
#include "bench/results/result_tables.h"
#include "bench/results/run_files.h"
#include "bench/scenario/publication.h"
#include "core/file/atomic_file.h"
#include "core/file/hash.h"
#include "core/file/text_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

template <class T>
void append(std::vector<T> more, std::vector<T>& all) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

// The journal last: what is left of a start that is killed here still says whose it is.
void remove_staging(const fs::path& staging) {
  for (const char* name : {"files", "tables", "journal"}) fs::remove_all(staging / name);
  fs::remove_all(staging);
}

void make_folder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) throw InputError({folder.string()}, "cannot be made: " + failed.message());
}

void copy_over(const fs::path& from, const fs::path& to) {
  std::error_code failed;
  fs::copy_file(from, to, fs::copy_options::overwrite_existing, failed);
  if (failed) {
    throw InputError({to.string()}, "cannot be written: " + failed.message(),
                     "start again when it can be; the runs are kept");
  }
}

std::string journal_in(const fs::path& staging) {
  return (staging / "journal").string();
}

}  // namespace

// The journal first: a folder without one is somebody else's.
StagingFolder::StagingFolder(const std::string& folder, const Results& planned,
                             const std::string& identity, bool afresh, const std::string& staging)
    : planned_(planned), folder_(folder), staging_(folder_ / staging) {
  const std::string journal = journal_in(staging_);
  if (fs::exists(journal)) {
    if (afresh || Journal::identity_of(journal).empty()) remove_staging(staging_);
  } else if (fs::exists(staging_) && !(fs::is_directory(staging_) && fs::is_empty(staging_))) {
    throw InputError({staging_.string()}, "is in the way: it holds no unfinished runs",
                     "move it away, or choose another folder with --out");
  }
  make_folder(staging_);
  journal_.emplace(journal, identity, planned.metrics.size());
  for (const char* name : {"files", "tables"}) make_folder(staging_ / name);
  // Tells a later start why runs that stay unfinished do not count any more.
  write_file((staging_ / "tables" / "config.yaml").string(), planned.config_yaml,
             Durability::unsynced);
  resume();
}

// A row may have got to the disk before a power cut, and its run's files not.
void StagingFolder::resume() {
  for (const Journal::Entry& entry : journal_->found()) {
    if (entry.given != checksum_of(entry.row.run)) continue;
    found_.push_back(entry);
    for (const FileOfRun& file : files_of(entry.row.run)) {
      run_by_file_.emplace(file.path, entry.row.run);
    }
  }
}

std::vector<FileOfRun> StagingFolder::files_of(int run) const {
  const std::string files = table("files", run);
  return files.empty() ? std::vector<FileOfRun>{} : parse_files(table_path("files", run), files);
}

void StagingFolder::own(const std::string& path, int run) {
  if (is_plot(planned_, path)) {
    throw InputError({path}, "would be the file of a plot and of a run",
                     "give the plot another 'file'");
  }
  if (is_foreign(folder_.string(), path)) refuse_foreign((folder_ / path).string());
  const auto [owner, is_new] = run_by_file_.emplace(path, run);
  if (is_new) return;
  throw InputError({path},
                   fmt::format("would be the file of run {} and of run {}", owner->second, run),
                   "give the variants names that differ in letters or digits");
}

// Files first: a run that is in the journal is there with all it gave.
void StagingFolder::commit(const RunResult& result) {
  Results of_run = planned_;
  of_run.runs = {result.row};
  of_run.series = result.series;
  for (const ResultFile& file : result.files) {
    of_run.files.push_back(file_of_run(file, result.row, planned_));
    own(of_run.files.back().path, result.row.run);
    const fs::path path = staging_ / "files" / of_run.files.back().path;
    make_folder(path.parent_path());
    write_file(path.string(), file.content, Durability::unsynced);
  }
  write_table("series", result.row.run, series_csv(of_run));
  write_table("files", result.row.run, files_csv(of_run));
  journal_->append({result.row, result.cost, checksum_of(result.row.run)});
}

// In the order of commit(), for the same reason.
void StagingFolder::take_over(const StagingFolder& other) {
  std::set<int> here;
  for (const Journal::Entry& entry : found_) here.insert(entry.row.run);
  for (const Journal::Entry& entry : other.found_) {
    const int run = entry.row.run;
    if (!here.insert(run).second) continue;
    for (const FileOfRun& file : other.files_of(run)) {
      own(file.path, run);
      const fs::path path = staging_ / "files" / file.path;
      make_folder(path.parent_path());
      copy_over(other.staging_ / "files" / file.path, path);
    }
    for (const char* kind : {"series", "files"}) write_table(kind, run, other.table(kind, run));
    journal_->append(entry);
    found_.push_back(entry);
  }
}

void StagingFolder::collect(Results& results) const {
  for (const RunRow& run : results.runs) {
    const std::string series = table("series", run.run);
    if (!series.empty()) {
      append(parse_series(table_path("series", run.run), series, results), results.series);
    }
    append(files_of(run.run), results.files);
  }
}

void StagingFolder::finish(const Results& results) {
  journal_.reset();
  publish(folder_.string(), results, kStaging);
}

std::string StagingFolder::table_path(const std::string& kind, int run) const {
  return (staging_ / "tables" / fmt::format("{}_{}.csv", kind, run)).string();
}

std::string StagingFolder::table(const std::string& kind, int run) const {
  const std::string path = table_path(kind, run);
  return fs::exists(path) ? read_text_file(path) : "";
}

void StagingFolder::write_table(const std::string& kind, int run, const std::string& csv) const {
  if (!csv.empty()) write_file(table_path(kind, run), csv, Durability::unsynced);
}

// Of the tables and files of a run; empty where they are damaged.
std::string StagingFolder::checksum_of(int run) const try {
  Sha256 sum;
  sum.add(sha256(table("series", run)) + sha256(table("files", run)));
  for (const FileOfRun& file : files_of(run)) {
    sum.add(sha256_of_file((staging_ / "files" / file.path).string()));
  }
  return sum.digits().substr(0, 16);
} catch (const InputError&) {
  return "";
}

void discard_staging(const std::string& folder, const std::string& identity) {
  const fs::path staging = fs::path(folder) / StagingFolder::kStaging;
  if (!fs::exists(journal_in(staging))) return;
  const std::string found = Journal::identity_of(journal_in(staging));
  if (found.empty() || found == identity) remove_staging(staging);
}

std::string finished_identity(const std::string& folder) try {
  if (!is_result_folder(folder)) return {};
  std::ifstream file(fs::path(folder) / "provenance.json");
  const auto json = nlohmann::json::parse(file);
  return json.at("runs_sha256").get<std::string>() +
         json.at("program").at("sha256").get<std::string>();
} catch (const nlohmann::json::exception&) {
  return {};
}

}  // namespace mapbed
