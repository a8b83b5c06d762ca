#pragma once

#include <string>

namespace mapbed {

// A folder of results as a run leaves it, with one of everything a page can show: claims that held
// and did not, a failed run, a figure, a map, a replay.
void make_example_results(const std::string& folder);

}  // namespace mapbed
