#pragma once

#include <string>
#include <vector>

#include "bench/results/result_file.h"
#include "bench/results/results.h"

namespace mapbed {

// What pages are made of.
struct ReportedResults {
  std::string folder;  // has the pictures
  Results results;
  std::vector<ResultFile> drawn = {};  // in the place of those that the folder has
};

}  // namespace mapbed
