#pragma once

#include <string>
#include <vector>

#include "bench/results/result_file.h"
#include "bench/results/results.h"

namespace mapbed {

// Whether the folder has the file with this content; one without content is to be missing.
bool is_as_written(const std::string& folder, const ResultFile& file);

// Writes them below the folder and removes those without content. What is as written is not
// touched.
void write_files(const std::string& folder, const std::vector<ResultFile>& files);

// Everything of results/<id>/ but the pictures: config.yaml, the tables of result_tables.h and
// provenance.json, in the order in which they are written. One that is not there has no content.
std::vector<ResultFile> files_of(const Results& results);

// Those of them that hold what the runs gave, and that nothing can make again. The provenance has
// their checksums.
std::vector<ResultFile> tables_of_runs(const Results& results);

// Writes all, and takes away those without content.
void write_results(const std::string& folder, const Results& results);

// Reads what write_results writes, which gives the same bytes again; and what older programs have
// written, which have their claims as sentences alone and do not list their pictures. Throws
// InputError where something is missing or damaged, or a table is not that of the provenance.
Results load_results(const std::string& folder);

// All that the result of a folder consists of, below the folder: tables, plots, the listed files of
// its runs and its page, be they there or not. Empty where the folder holds no result that can be
// read.
std::vector<std::string> paths_of_result(const std::string& folder);

// Whether that file is one of a scenario's plots.
bool is_plot(const Results& results, const std::string& path);

// Throws InputError where tables or plots of `planned` would take the place of somebody else's
// files.
void refuse_foreign_files(const std::string& folder, const Results& planned);

// Whether that file of a run would.
bool is_foreign(const std::string& folder, const std::string& path);

bool is_result_folder(const std::string& folder);  // has config.yaml and summary.csv

// The folder itself or, where it is none, those of its folders that are, by name. Throws InputError
// where there are no results.
std::vector<std::string> result_folders(const std::string& folder);

}  // namespace mapbed
