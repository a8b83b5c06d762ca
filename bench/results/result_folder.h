#pragma once

#include <string>
#include <vector>

#include "core/file/csv_file.h"

namespace mapbed {

// A table as it stands in a file; the first row are the names of the columns. Empty: no such file.
using CsvTable = std::vector<CsvRow>;

// The value in the column of that name; empty where there is no such column.
std::string field(const CsvTable& table, std::size_t row, const std::string& column);

struct NamedFile {
  std::string name;  // "translation_error.svg", "first_seed/matched.png": below the folder it is of
  std::string content;
};

// What stands in results/<id>/, as far as a page shows it. Pictures and replays are sorted by name,
// but the scenario's own plots come first, in its order.
struct ResultFolder {
  std::string folder;
  std::string id;
  std::string about;                 // the question
  std::string thesis;                // "Figure 3.10"; empty: nothing of the thesis
  bool quick = false;                // the reduced run
  std::vector<std::string> skipped;  // what was not run and why
  CsvTable claims, summary, runs, cost;
  std::vector<NamedFile> figures;  // SVG
  std::vector<NamedFile> maps;     // PNG
  std::vector<NamedFile> replays;  // JSON, see replay.h
  std::string config;              // YAML
  std::string provenance;          // JSON
};

bool is_result_folder(const std::string& folder);  // has config.yaml and summary.csv

// The folder itself or, where it is none, those of its folders that are, by name. Throws InputError
// where there are no results.
std::vector<std::string> result_folders(const std::string& folder);

// Throws InputError where something is missing or damaged.
ResultFolder load_result_folder(const std::string& folder);

struct ClaimCount {
  int held = 0;
  int not_held = 0;
  int not_judged = 0;
};
ClaimCount claims_of(const ResultFolder& result);

struct RunCount {
  int runs = 0;
  int failed = 0;
};
RunCount runs_of(const ResultFolder& result);

}  // namespace mapbed
