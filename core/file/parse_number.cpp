#include "core/file/parse_number.h"

#include <cmath>

namespace mapbed {

bool parse_number(std::string_view word, double& number) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  return !word.empty() && read_number(word.data(), end, number) == end && std::isfinite(number);
}

double number_of(std::string_view word, const SourceLocation& place, const std::string& remedy) {
  double number = 0.0;
  if (parse_number(word, number)) return number;
  throw InputError(place, in_quotes(word) + " is not a number", remedy);
}

}  // namespace mapbed
