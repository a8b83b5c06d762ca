#pragma once

#include <string>
#include <vector>

#include "bench/results/results.h"

namespace mapbed {

struct ReportedResults {
  std::string folder;
  Results results;
};

// All results of a folder on one page: what was asked, which claims held, the figures.
std::string overview_page(const std::vector<ReportedResults>& all);

// The same for people who read the folder where Markdown is shown.
std::string overview_markdown(const std::vector<ReportedResults>& all);

// Throw InputError where a page would take the place of a report.html or README.md that this
// program has not written: of one result, and of all that write_reports would write.
void refuse_foreign_page(const std::string& folder);
void refuse_foreign_pages(const std::string& folder);

// Of a folder of results: its page. Of a folder that holds such folders: the page of each, and
// the overview as report.html and README.md. Gives the pages written. Throws InputError where there
// are no results or pages would be refused; then it writes none.
std::vector<std::string> write_reports(const std::string& folder);

}  // namespace mapbed
