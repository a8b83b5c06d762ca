#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/file/parse_number.h"

// Text cut into lines, words and numbers. Words stand between blanks, tabs and the "\r" that some
// files have before their line ends.

namespace mapbed {

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

// The first line of `text`, cut off, without its line end ("\n" or "\r\n").
std::string_view next_line(std::string_view& text);

std::string_view next_word(std::string_view& line);      // cut off as well; empty at the line's end
std::string_view without_blanks(std::string_view text);  // at either end
std::size_t words_in(std::string_view line);

// The words of a line, one after the other. Once one is missing or is not what was asked for, ok()
// is false and every further number is 0.
class Tokens {
 public:
  explicit Tokens(std::string_view line) : at_(line.data()), end_(line.data() + line.size()) {}

  bool ok() const { return ok_; }
  bool at_end() {
    skip_blanks();
    return at_ == end_;
  }
  // Where ok() is false: the word that is not what was asked for; empty where the line ended.
  std::string_view wrong() const {
    std::string_view left = rest();
    return next_word(left);
  }
  std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }

  std::string_view word() {
    std::string_view left = rest();
    const std::string_view found = next_word(left);
    at_ = left.data();
    if (found.empty()) ok_ = false;
    return found;
  }

  double number() {
    skip_blanks();
    double value = 0.0;
    const char* rest = ok_ && at_ != end_ ? read_number(at_, end_, value) : nullptr;
    if (rest == nullptr && ok_ && at_ != end_) rest = read_odd_number(at_, end_, value);
    if (rest == nullptr || (rest != end_ && !is_blank(*rest))) {
      ok_ = false;
      return 0.0;
    }
    at_ = rest;
    return value;
  }

  std::size_t count();                    // a whole number, no larger than the line is long
  std::vector<double> counted_numbers();  // n, then n numbers

 private:
  void skip_blanks() {
    while (at_ != end_ && is_blank(*at_)) ++at_;
  }

  const char* at_;
  const char* end_;
  bool ok_ = true;
};

}  // namespace mapbed
