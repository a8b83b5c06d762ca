#pragma once

#include <set>
#include <string>
#include <vector>

namespace mapbed {

// Throw InputError where a page would take the place of a report.html or README.md that this
// program has not written: of one result, and of all that write_reports would write.
void refuse_foreign_page(const std::string& folder);
void refuse_foreign_pages(const std::string& folder);

// The page of a result that was just made.
void write_page(const std::string& folder);

// Judges the claims and draws the figures again from the tables, and writes the pages: of a folder
// of results its own; of a folder that holds such folders that of each, and the overview as
// report.html and README.md. Gives the pages. Those results that are `busy` are shown as they are,
// and not touched. Throws InputError where there are no results, where pages would be refused or
// where not all of it can be written; then nothing has changed. Where the program is killed, each
// result is the older or the new one, with its page. The folders are locked, and nothing is being
// published in them.
std::vector<std::string> write_reports(const std::string& folder,
                                       const std::set<std::string>& busy = {});

}  // namespace mapbed
