#pragma once

#include <string>
#include <vector>

#include "bench/results/result_file.h"
#include "bench/results/results.h"

namespace mapbed {

// How a file of a run stands in the result's folder: "maps/map.png" as "maps/map_level_2_raw.png",
// with the title that it was given or else the words of its name.
FileOfRun file_of_run(const ResultFile& file, const RunRow& run, const Results& results);

// The same found out by the names of files, for results that were written before they were listed.
// Those that are not of a run are left out.
std::vector<FileOfRun> files_by_name(const std::vector<std::string>& paths, const Results& results);

// Paths as people sort: "after_90_s" before "after_130_s".
bool in_natural_order(const std::string& a, const std::string& b);

}  // namespace mapbed
