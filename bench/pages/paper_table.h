#pragma once

// Tables of a result as they stand in papers and notes: means with their 95 % intervals, variants
// side by side.

#include <string>
#include <vector>

#include "bench/results/results.h"

namespace mapbed {

struct PaperTable {
  std::string about;  // "translation error [m], mean of 10 runs with its 95 % interval"
  std::vector<std::string> head = {};
  std::size_t names = 0;  // how many columns, the first ones, say what a row is
  std::vector<std::vector<std::string>> rows = {};  // as many texts as the head
};

// Where there are several levels and variants, a table for each metric with a column for each
// variant and a row for each level; else one with a column for each metric. Rows and columns
// without any value are left out, as are tables. No metrics: all that were measured. Throws
// InputError for a metric that was not.
std::vector<PaperTable> paper_tables(const Results& results,
                                     const std::vector<std::string>& metrics);

// Of LaTeX a tabular by the package booktabs.
std::string latex_of(const PaperTable& table);
std::string markdown_of(const PaperTable& table);

// Any text in a line or in a cell.
std::string latex_escaped(const std::string& text);
std::string markdown_escaped(const std::string& text);

}  // namespace mapbed
