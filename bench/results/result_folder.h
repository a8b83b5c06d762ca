#pragma once

#include <string>
#include <vector>

#include "bench/results/result_file.h"
#include "bench/results/results.h"

namespace mapbed {

// Everything of results/<id>/ but the pictures: config.yaml, the tables of result_tables.h and
// provenance.json, in the order in which they are written. One that is not there has no content.
std::vector<ResultFile> files_of(const Results& results);

// Writes them, and takes away those without content and the pictures that an older result of the
// folder lists and this one does not. The provenance comes last: it says that the result is whole.
void write_results(const std::string& folder, const Results& results);

// Reads what write_results writes, which gives the same bytes again; and what older programs have
// written, which have their claims as sentences alone and do not list their pictures. Throws
// InputError where something is missing or damaged.
Results load_results(const std::string& folder);

bool is_result_folder(const std::string& folder);  // has config.yaml and summary.csv

// The folder itself or, where it is none, those of its folders that are, by name. Throws InputError
// where there are no results.
std::vector<std::string> result_folders(const std::string& folder);

}  // namespace mapbed
