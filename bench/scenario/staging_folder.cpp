#include "bench/scenario/staging_folder.h"

#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/results/result_folder.h"
#include "bench/results/result_tables.h"
#include "bench/results/run_files.h"
#include "core/file/atomic_file.h"
#include "core/file/text_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

template <class T>
void append(std::vector<T> more, std::vector<T>& all) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

// Files that are not here any more were moved by a start that was killed.
void move_files(const fs::path& from, const fs::path& to) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(from)) {
    if (entry.is_regular_file()) found.push_back(entry.path());
  }
  for (const fs::path& path : found) {
    const fs::path target = to / fs::relative(path, from);
    fs::create_directories(target.parent_path());
    fs::rename(path, target);
  }
}

}  // namespace

StagingFolder::StagingFolder(const std::string& folder, const Results& planned,
                             const std::string& identity, bool afresh)
    : planned_(planned), folder_(folder), staging_(folder_ / "runs") {
  if (afresh) fs::remove_all(staging_);
  std::error_code failed;
  fs::create_directories(staging_ / "files", failed);
  if (failed) throw InputError({staging_.string()}, "cannot be made: " + failed.message());
  fs::create_directories(staging_ / "tables");
  journal_.emplace((staging_ / "journal").string(), identity, planned.metrics.size());
}

// Files first: a run that is in the journal is there with all it gave.
void StagingFolder::commit(const RunResult& result) {
  Results of_run = planned_;
  of_run.runs = {result.row};
  of_run.series = result.series;
  for (const ResultFile& file : result.files) {
    of_run.files.push_back(file_of_run(file, result.row, planned_));
    const fs::path path = staging_ / "files" / of_run.files.back().path;
    fs::create_directories(path.parent_path());
    write_file(path.string(), file.content);
  }
  write_table("series", result.row.run, series_csv(of_run));
  write_table("files", result.row.run, files_csv(of_run));
  journal_->append({result.row, result.cost});
}

void StagingFolder::collect(Results& results) const {
  for (const RunRow& run : results.runs) {
    const std::string series = table_path("series", run.run);
    if (fs::exists(series)) {
      append(parse_series(series, read_text_file(series), results), results.series);
    }
    const std::string files = table_path("files", run.run);
    if (fs::exists(files)) append(parse_files(files, read_text_file(files)), results.files);
  }
}

void StagingFolder::finish(const Results& results) {
  move_files(staging_ / "files", folder_);
  write_results(folder_.string(), results);
  journal_.reset();
  fs::remove_all(staging_);
}

std::string StagingFolder::table_path(const std::string& kind, int run) const {
  return (staging_ / "tables" / fmt::format("{}_{}.csv", kind, run)).string();
}

void StagingFolder::write_table(const std::string& kind, int run, const std::string& csv) const {
  if (!csv.empty()) write_file(table_path(kind, run), csv);
}

std::string finished_identity(const std::string& folder) {
  std::ifstream file(fs::path(folder) / "provenance.json");
  const auto json = nlohmann::json::parse(file, nullptr, false);
  if (!json.is_object() || !json.contains("program")) return {};
  return json.value("runs_sha256", "") + json["program"].value("sha256", "");
}

}  // namespace mapbed
