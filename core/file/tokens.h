#pragma once

#include <charconv>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/input_error.h"

// Text cut into lines, words and numbers. Words stand between blanks, tabs and the "\r" that some
// files have before their line ends; numbers are those of std::from_chars, whatever the locale.

namespace mapbed {

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

// A number at the beginning of a text, the very bits of std::from_chars, some four times as fast
// for plain decimals: up to 15 digits and 22 decimals make an exact integer divided by an exact
// power of ten, which rounds once, so correctly. Returns the end of the number, or nullptr where
// none is.
inline const char* read_number(const char* text, const char* end, double& value) {
  static constexpr double kPowersOfTen[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                            1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const char* p = text;
  const bool negative = p != end && *p == '-';
  if (negative) ++p;
  std::uint64_t mantissa = 0;
  const char* const digits = p;
  while (p != end && static_cast<unsigned char>(*p - '0') < 10)
    mantissa = mantissa * 10 + static_cast<unsigned char>(*p++ - '0');
  auto count = p - digits;
  std::ptrdiff_t decimals = 0;
  if (p != end && *p == '.') {
    const char* const fraction = ++p;
    while (p != end && static_cast<unsigned char>(*p - '0') < 10)
      mantissa = mantissa * 10 + static_cast<unsigned char>(*p++ - '0');
    decimals = p - fraction;
    count += decimals;
  }
  const bool plain = count > 0 && count <= 15 && (p == end || (*p | 0x20) != 'e');
  if (plain && (p == end || *p == ' ' || *p == '\t' || *p == '\r')) {
    const double magnitude = static_cast<double>(mantissa) / kPowersOfTen[decimals];
    value = negative ? -magnitude : magnitude;
    return p;
  }
  const auto [rest, error] = std::from_chars(text, end, value);
  return error == std::errc() ? rest : nullptr;
}

// A finite number that fills the whole word, with or without a sign; false where the word is
// anything else.
bool parse_number(std::string_view word, double& number);

// The same of a whole number that its type can hold.
template <std::integral Integer>
bool parse_number(std::string_view word, Integer& number) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc{} && end == word.data() + word.size();
}

// The number that a word is. Throws InputError where it is not a finite one: "'x' is not a number".
double number_of(std::string_view word, const SourceLocation& place, const std::string& remedy);

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
    const char* const rest = ok_ && at_ != end_ ? read_number(at_, end_, value) : nullptr;
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
