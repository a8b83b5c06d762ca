#include "bench/results/result_folder.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <nlohmann/json.hpp>

#include "bench/process/foreign_files.h"
#include "bench/results/plan_yaml.h"
#include "bench/results/result_tables.h"
#include "bench/results/run_files.h"
#include "core/file/atomic_file.h"
#include "core/file/hash.h"
#include "core/file/text_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  return fs::exists(path) ? read_text_file(path.string()) : "";
}

// Paths of all pictures and the like, as people sort them.
std::vector<std::string> pictures_in(const fs::path& folder) {
  std::vector<std::string> paths;
  for (const char* inner : {"figures", "maps", "replays", "trajectories", "learned"}) {
    if (!fs::is_directory(folder / inner)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(folder / inner)) {
      if (!entry.is_regular_file()) continue;
      paths.push_back(entry.path().lexically_relative(folder).string());
    }
  }
  std::sort(paths.begin(), paths.end(), in_natural_order);
  return paths;
}

std::vector<FileOfRun> found_files(const fs::path& folder, const Results& results) {
  std::vector<std::string> paths = pictures_in(folder);
  std::erase_if(paths, [&](const std::string& path) { return is_plot(results, path); });
  return files_by_name(paths, results);
}

// A table that somebody has edited or cut short gives no figures and no verdicts.
void check_tables(const fs::path& folder, const std::string& provenance_json) {
  const auto json = nlohmann::json::parse(provenance_json, nullptr, false);
  if (!json.is_object() || !json.contains("tables_sha256")) return;  // of an older program
  const auto& checksums = json["tables_sha256"];
  for (const ResultFile& table : tables_of_runs(Results{})) {
    if (!checksums.is_object() || !checksums.contains(table.path)) continue;
    const std::string path = (folder / table.path).string();
    if (checksums[table.path] == sha256(text_of(path))) continue;
    throw InputError({path}, "is not the table that was written: rows were changed, lost or added",
                     "put it back, or make all runs again with 'mapbed run --restart'");
  }
}

std::vector<std::string> plot_paths(const Results& results) {
  std::vector<std::string> paths;
  for (const PlotSpec& plot : results.plots) {
    for (const char* kind : {".svg", ".csv"}) paths.push_back("figures/" + plot.file + kind);
  }
  return paths;
}

void append(const std::vector<std::string>& more, std::vector<std::string>& all) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

bool is_plot(const Results& results, const std::string& path) {
  const std::vector<std::string> paths = plot_paths(results);
  return std::find(paths.begin(), paths.end(), path) != paths.end();
}

bool is_as_written(const std::string& folder, const ResultFile& file) {
  const fs::path path = fs::path(folder) / file.path;
  std::error_code error;
  if (file.content.empty()) return fs::symlink_status(path).type() == fs::file_type::not_found;
  if (!fs::is_regular_file(path) || fs::file_size(path, error) != file.content.size()) return false;
  return read_text_file(path.string()) == file.content;
}

void write_files(const std::string& folder, const std::vector<ResultFile>& files) {
  for (const ResultFile& file : files) {
    if (is_as_written(folder, file)) continue;
    const fs::path path = fs::path(folder) / file.path;
    std::error_code error;
    if (file.content.empty()) {
      fs::remove(path, error);
    } else {
      fs::create_directories(path.parent_path(), error);
    }
    if (error) throw InputError({path.string()}, "cannot be written: " + error.message());
    if (!file.content.empty()) write_file(path.string(), file.content);
  }
}

std::vector<ResultFile> files_of(const Results& results) {
  return {{"config.yaml", results.config_yaml},
          {"runs.csv", runs_csv(results)},
          {"summary.csv", summary_csv(results)},
          {"series.csv", series_csv(results)},
          {"claims.csv", claims_csv(results)},
          {"cost_claims.csv", cost_claims_csv(results)},
          {"cost.csv", cost_csv(results)},
          {"files.csv", files_csv(results)},
          {"provenance.json", results.provenance_json}};
}

std::vector<ResultFile> tables_of_runs(const Results& results) {
  return {{"runs.csv", runs_csv(results)},
          {"series.csv", series_csv(results)},
          {"cost.csv", cost_csv(results)},
          {"files.csv", files_csv(results)}};
}

void write_results(const std::string& folder, const Results& results) {
  write_files(folder, files_of(results));
}

Results load_results(const std::string& folder) {
  const fs::path base(folder);
  if (!is_result_folder(folder)) {
    throw InputError({folder}, "is not a folder of results: it has no config.yaml and summary.csv",
                     "make one with 'mapbed run SCENARIO'");
  }
  const auto path = [&](const char* name) { return (base / name).string(); };
  Results results = load_plan(path("config.yaml"));
  results.provenance_json = text_of(path("provenance.json"));
  check_tables(base, results.provenance_json);
  results.config_yaml = read_text_file(path("config.yaml"));
  results.runs = parse_runs(path("runs.csv"), read_text_file(path("runs.csv")), results);
  results.summary =
      parse_summary(path("summary.csv"), read_text_file(path("summary.csv")), results);
  results.verdicts = parse_verdicts(path("claims.csv"), read_text_file(path("claims.csv")), false);
  results.costs = parse_costs(path("cost.csv"), read_text_file(path("cost.csv")));
  if (const std::string csv = text_of(path("cost_claims.csv")); !csv.empty()) {
    const std::vector<Verdict> of_cost = parse_verdicts(path("cost_claims.csv"), csv, true);
    results.verdicts.insert(results.verdicts.end(), of_cost.begin(), of_cost.end());
  }
  if (const std::string csv = text_of(path("series.csv")); !csv.empty()) {
    results.series = parse_series(path("series.csv"), csv, results);
  }
  if (const std::string csv = text_of(path("files.csv")); !csv.empty()) {
    results.files = parse_files(path("files.csv"), csv);
  } else {
    results.files = found_files(base, results);
  }
  return results;
}

std::vector<std::string> paths_of_result(const std::string& folder) try {
  const fs::path base(folder);
  if (!fs::exists(base / "config.yaml")) return {};
  std::vector<std::string> paths{"report.html"};
  for (const ResultFile& file : files_of(Results{})) paths.push_back(file.path);
  append(plot_paths(load_plan((base / "config.yaml").string())), paths);
  const std::string list = (base / "files.csv").string();
  if (const std::string csv = text_of(list); !csv.empty()) {  // none where the runs wrote nothing
    for (const FileOfRun& file : parse_files(list, csv)) paths.push_back(file.path);
  }
  return paths;
} catch (const InputError&) {
  return {};
}

void refuse_foreign_files(const std::string& folder, const Results& planned) {
  std::vector<std::string> coming;
  for (const ResultFile& file : files_of(Results{})) coming.push_back(file.path);
  append(plot_paths(planned), coming);
  refuse_foreign(folder, coming, paths_of_result(folder));
}

bool is_foreign(const std::string& folder, const std::string& path) {
  if (!fs::exists(fs::symlink_status(fs::path(folder) / path))) return false;
  const std::vector<std::string> ours = paths_of_result(folder);
  const bool lists_all = ours.empty() || fs::exists(fs::path(folder) / "files.csv");
  return lists_all && std::find(ours.begin(), ours.end(), path) == ours.end();
}

bool is_result_folder(const std::string& folder) {
  return fs::is_regular_file(fs::path(folder) / "config.yaml") &&
         fs::is_regular_file(fs::path(folder) / "summary.csv");
}

std::vector<std::string> result_folders(const std::string& folder) {
  if (!fs::is_directory(folder)) throw InputError({folder}, "there is no such folder");
  if (is_result_folder(folder)) return {folder};
  std::vector<std::string> folders;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (is_result_folder(entry.path().string())) folders.push_back(entry.path().string());
  }
  if (folders.empty()) {
    throw InputError({folder}, "holds no results: no folder with a config.yaml and a summary.csv",
                     "make some with 'mapbed run SCENARIO'");
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

}  // namespace mapbed
