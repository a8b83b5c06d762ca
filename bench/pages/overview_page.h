#pragma once

#include <string>
#include <vector>

#include "bench/pages/reported_results.h"

namespace mapbed {

// All results of a folder on one page: what was asked, which claims held, the figures.
std::string overview_page(const std::vector<ReportedResults>& all);

// The same for people who read the folder where Markdown is shown.
std::string overview_markdown(const std::vector<ReportedResults>& all);

// Whether overview_markdown has made what stands in that file, now or in an earlier version.
bool is_markdown_of_ours(const std::string& path);

}  // namespace mapbed
