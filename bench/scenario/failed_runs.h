#pragma once

#include <string>

namespace mapbed {

struct Results;

// What it means that runs failed, the most frequent reasons with how many have each, and where all
// of them stand; `folder` is that of the results. Reasons that differ in numbers alone count as
// one. Empty where none failed.
std::string failed_runs_text(const Results& results, const std::string& folder);

}  // namespace mapbed
