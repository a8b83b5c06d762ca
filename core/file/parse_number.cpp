#include "core/file/parse_number.h"

#include <cmath>
#include <limits>

#include "core/file/tokens.h"

namespace mapbed {

const char* read_odd_number(const char* text, const char* end, double& value) {
  const bool negative = text != end && *text == '-';
  if (text != end && (*text == '-' || *text == '+')) ++text;
  std::string_view rest(text, static_cast<std::size_t>(end - text));
  const std::string_view word = next_word(rest);
  if (word.empty() || word[0] == '-' || word[0] == '+') return nullptr;
  const char* const after = word.data() + word.size();
  const auto is_one_of = [word](auto... names) { return ((word == names) || ...); };
  if (is_one_of(".inf", ".Inf", ".INF")) {
    value = negative ? -std::numeric_limits<double>::infinity()
                     : std::numeric_limits<double>::infinity();
  } else if (is_one_of(".nan", ".NaN", ".NAN")) {
    value = std::numeric_limits<double>::quiet_NaN();
  } else {
    if (negative || read_number(word.data(), after, value) != after) return nullptr;
  }
  return after;
}

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
