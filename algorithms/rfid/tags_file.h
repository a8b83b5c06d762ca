#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "algorithms/tag_belief.h"

// Where tags are, as a table: a row for each position that a tag may have, `tag,x,y,weight`; rows
// of a tag stand together and need not sum to 1. Without the last column, or with one row, the
// tag's place is known.

namespace mapbed {

std::string tags_text(const std::vector<TagBelief>& tags);

// By the tags' order in the text. Throws InputError with `name` and line.
std::vector<TagBelief> parse_tags(const std::string& name, std::string_view text);
std::vector<TagBelief> load_tags(const std::string& path);

}  // namespace mapbed
