#include "core/file/tokens.h"

#include <algorithm>

namespace mapbed {

std::string_view next_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::string_view next_word(std::string_view& line) {
  std::size_t begin = 0;
  while (begin < line.size() && is_blank(line[begin])) ++begin;
  std::size_t end = begin;
  while (end < line.size() && !is_blank(line[end])) ++end;
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

std::size_t words_in(std::string_view line) {
  std::size_t count = 0;
  while (!next_word(line).empty()) ++count;
  return count;
}

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::size_t Tokens::count() {
  const double value = number();
  if (!(value >= 0.0) || value > static_cast<double>(rest().size()) ||
      value != static_cast<double>(static_cast<std::size_t>(value))) {
    ok_ = false;
    return 0;
  }
  return static_cast<std::size_t>(value);
}

std::vector<double> Tokens::counted_numbers() {
  std::vector<double> values;
  const std::size_t n = count();
  values.reserve(n);
  for (std::size_t i = 0; i < n && ok_; ++i) values.push_back(number());
  return values;
}

}  // namespace mapbed
