#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mapbed {

// Letters to insert, delete, replace, or swap with their neighbour, to make b from a
// (Damerau-Levenshtein distance, optimal string alignment; case counts for nothing).
std::size_t edit_distance(std::string_view a, std::string_view b);

// The candidate that `word` was probably meant to be: at most one mistake in three letters. Empty
// if none is near; the first of equally near ones.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

// "did you mean 'rotation_sigma'?", or else "known are: a, b, c"; the remedy of an InputError.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace mapbed
