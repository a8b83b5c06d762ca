#include "bench/scenario/publication.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <vector>

#include "bench/results/figures.h"
#include "bench/results/result_folder.h"
#include "core/file/atomic_file.h"
#include "core/file/csv_file.h"
#include "core/file/text_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

// Lines of the list: what to do, and with which paths below the result's folder.
constexpr const char* kRemove = "remove";  // a file
constexpr const char* kMove = "move";      // a file, from, to
constexpr const char* kDrop = "drop";      // a folder with all that is in it

fs::path work_folder(const fs::path& folder) {
  return folder / ".publication";
}

fs::path list_in(const fs::path& folder) {
  return work_folder(folder) / "list";
}

// Figures, page and tables. The configuration is last: a folder without it is no result's.
std::vector<ResultFile> made_of(const Results& results, const std::string& page) {
  std::vector<ResultFile> files = figure_files(results);
  const std::vector<ResultFile> tables = files_of(results);
  files.push_back({"report.html", page});
  files.insert(files.end(), tables.begin(), tables.end());
  std::erase_if(files, [](const ResultFile& file) { return file.content.empty(); });
  std::stable_partition(files.begin(), files.end(),
                        [](const ResultFile& file) { return file.path != "config.yaml"; });
  return files;
}

// Of the older result, what the new one does not have.
std::vector<std::string> gone_from(const std::string& folder, const std::vector<ResultFile>& made,
                                   const Results& results) {
  std::set<std::string> now;
  for (const ResultFile& file : made) now.insert(file.path);
  for (const FileOfRun& file : results.files) now.insert(file.path);
  std::vector<std::string> gone = paths_of_result(folder);
  std::erase_if(gone, [&](const std::string& path) {
    return now.contains(path) || !fs::exists(fs::path(folder) / path);
  });
  return gone;
}

bool is_page(const std::string& path) {
  return path == "report.html";
}

void sync_files(const fs::path& base, const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    if (fs::exists(base / path)) sync_file((base / path).string());
  }
}

// The folders that files are in, and `base`: their names are on the disk behind this.
void sync_folders_of(const fs::path& base, const std::vector<std::string>& paths) {
  std::set<fs::path> folders{base};
  for (const std::string& path : paths) {
    fs::path inner = fs::path(path).parent_path();
    for (; !inner.empty(); inner = inner.parent_path()) folders.insert(base / inner);
  }
  for (const fs::path& folder : folders) {
    if (fs::exists(folder)) sync_folder(folder.string());
  }
}

// Where the older result leaves an empty folder, that goes too.
void remove_file(const fs::path& folder, const std::string& path) {
  fs::remove(folder / path);
  for (fs::path inner = fs::path(path).parent_path(); !inner.empty(); inner = inner.parent_path()) {
    std::error_code error;
    if (!fs::is_empty(folder / inner, error) || error) return;
    fs::remove(folder / inner, error);
  }
}

// As often as needed: what is done already is passed over.
void carry_out(const fs::path& folder, const std::vector<CsvRow>& list) {
  std::set<std::string> arrived;
  std::vector<std::string> targets;
  for (const CsvRow& line : list) {
    if (line[0] != kMove) continue;
    targets.push_back(line[2]);
    if (!fs::exists(folder / line[1])) arrived.insert(line[2]);
  }
  for (const CsvRow& line : list) {
    if (line[0] == kRemove && !arrived.contains(line[1])) remove_file(folder, line[1]);
  }
  for (const CsvRow& line : list) {
    if (line[0] != kMove || arrived.contains(line[2])) continue;
    fs::create_directories((folder / line[2]).parent_path());
    fs::rename(folder / line[1], folder / line[2]);
  }
  sync_folders_of(folder, targets);
  for (const CsvRow& line : list) {
    if (line[0] == kDrop) fs::remove_all(folder / line[1]);
  }
}

[[noreturn]] void refuse(const std::string& folder, const fs::filesystem_error& error) {
  throw InputError({error.path1().empty() ? folder : error.path1().string()},
                   "cannot be written: " + error.code().message(),
                   "start again when it can be; the runs are kept");
}

// What runs gave stays as the program wrote it that made them, where the provenance in place has
// its checksums: today's would write the same numbers in other bytes.
void leave_tables_of_runs(const std::string& folder, const Results& results,
                          std::vector<ResultFile>& made) {
  const bool has_checksums = results.provenance_json.find("\"tables_sha256\"") != std::string::npos;
  if (!has_checksums || !is_as_written(folder, {"provenance.json", results.provenance_json}))
    return;
  for (const ResultFile& table : tables_of_runs(results)) {
    if (!fs::exists(fs::path(folder) / table.path)) continue;
    std::erase_if(made, [&](const ResultFile& file) { return file.path == table.path; });
  }
}

}  // namespace

Publication::Publication(const std::string& folder, const Results& results,
                         const std::string& staging, const std::string& page)
    : Publication(folder) {
  std::vector<ResultFile> made = made_of(results, page);
  const std::vector<std::string> gone = gone_from(folder, made, results);
  if (staging.empty()) leave_tables_of_runs(folder, results, made);
  const bool is_other =
      !staging.empty() ||
      std::any_of(gone.begin(), gone.end(), [](const auto& path) { return !is_page(path); }) ||
      std::any_of(made.begin(), made.end(), [&](const ResultFile& file) {
        return !is_page(file.path) && !is_as_written(folder, file);
      });
  // The configuration goes first and comes last, though it be the same; a page alone needs no such
  // care, and none goes that is of these very results.
  std::erase_if(made, [&](const ResultFile& file) {
    return is_as_written(folder, file) && !(is_other && file.path == "config.yaml");
  });
  if (is_other) {
    list_.push_back({kRemove, "config.yaml", ""});
    for (const std::string& path : gone) list_.push_back({kRemove, path, ""});
  }
  if (!staging.empty()) {
    for (const FileOfRun& file : results.files) {
      list_.push_back({kMove, staging + "/files/" + file.path, file.path});
    }
  }
  make(made);
  if (!staging.empty()) list_.push_back({kDrop, staging, ""});
  sync();
}

Publication::Publication(const std::string& folder, const std::vector<ResultFile>& files)
    : Publication(folder) {
  std::vector<ResultFile> made = files;
  std::erase_if(made, [&](const ResultFile& file) { return is_as_written(folder, file); });
  make(made);
  sync();
}

Publication::Publication(const std::string& folder, const std::string& mark) : Publication(folder) {
  list_.push_back({kRemove, mark, ""});
}

Publication::~Publication() {
  std::error_code none;
  if (!fs::exists(list_in(folder_), none)) fs::remove_all(work_folder(folder_), none);
}

std::string Publication::add(const std::string& path) try {
  const std::string coming = ".publication/new/" + path;
  const fs::path file = fs::path(folder_) / coming;
  fs::create_directories(file.parent_path());
  list_.push_back({kMove, coming, path});
  return file.string();
} catch (const fs::filesystem_error& error) {
  refuse(folder_, error);
}

void Publication::remove(const std::string& path) {
  list_.push_back({kRemove, path, ""});
}

void Publication::make(const std::vector<ResultFile>& files) {
  for (const ResultFile& file : files) {
    write_file(add(file.path), file.content, Durability::unsynced);
  }
}

void Publication::sync() const {
  std::vector<std::string> paths;
  for (const CsvRow& line : list_) {
    if (line[0] == kMove) paths.push_back(line[1]);
  }
  sync_files(folder_, paths);
  sync_folders_of(folder_, paths);
}

void Publication::commit() {
  if (list_.empty()) return;
  sync();
  write_file(list_in(folder_).string(), csv_text(list_));
  finish_publication(folder_);
}

void publish(const std::string& folder, const Results& results, const std::string& staging) {
  Publication(folder, results, staging).commit();
}

void finish_publication(const std::string& folder) try {
  if (!is_being_published(folder)) return;
  const std::string list = list_in(folder).string();
  if (fs::exists(list)) {
    carry_out(folder, parse_csv(list, read_text_file(list)));
    fs::remove(list);
  }
  fs::remove_all(work_folder(folder));
} catch (const fs::filesystem_error& error) {
  refuse(folder, error);
}

bool is_being_published(const std::string& folder) {
  return fs::exists(work_folder(folder));
}

}  // namespace mapbed
