#pragma once

#include <functional>
#include <string>
#include <vector>

namespace mapbed {

struct BagContents;

// Something that has a name on the command line.
struct CatalogueEntry {
  std::string name;
  std::string about;
  std::function<std::string()> describe;  // every option with default, unit and meaning, as YAML
  std::string specification = {};  // in a line, with its source; empty: it has none but its name
};

// Things of one kind. The entries are looked up only when asked for: some stand in files.
struct CatalogueShelf {
  std::string kind;  // "methods"
  std::string one;   // "method"
  std::function<std::vector<CatalogueEntry>()> entries;
};

const std::vector<CatalogueShelf>& catalogue();

// What the file of a log, or of its description, holds: its lasers, where each of them looks and
// who says so, and what is odd about it. Throws InputError where it cannot be read.
std::string text_of_log(const std::string& path);

// Its topics, with their types and how many messages each has.
std::string text_of_bag(const BagContents& bag);

}  // namespace mapbed
