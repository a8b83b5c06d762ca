#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <system_error>
#include <vector>

namespace mapbed {

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

// The blank-separated fields of a line, one after the other. Once a field is missing or is not what
// was asked for, ok() is false and every further number is 0.
class Fields {
 public:
  explicit Fields(std::string_view line) : at_(line.data()), end_(line.data() + line.size()) {}

  bool ok() const { return ok_; }
  bool at_end() {
    skip_blanks();
    return at_ == end_;
  }
  std::string_view characters() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }

  std::string_view word() {
    skip_blanks();
    const char* const begin = at_;
    while (at_ != end_ && !is_blank(*at_)) ++at_;
    if (at_ == begin) ok_ = false;
    return {begin, static_cast<std::size_t>(at_ - begin)};
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

  // A count of fields that follow: a whole number, and no more than the line has room for.
  std::size_t count() {
    const double value = number();
    if (!(value >= 0.0) || value > static_cast<double>(characters().size()) ||
        value != static_cast<double>(static_cast<std::size_t>(value))) {
      ok_ = false;
      return 0;
    }
    return static_cast<std::size_t>(value);
  }

  // n, then n numbers.
  std::vector<double> counted_numbers() {
    std::vector<double> values;
    const std::size_t n = count();
    values.reserve(n);
    for (std::size_t i = 0; i < n && ok_; ++i) values.push_back(number());
    return values;
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  void skip_blanks() {
    while (at_ != end_ && is_blank(*at_)) ++at_;
  }

  const char* at_;
  const char* end_;
  bool ok_ = true;
};

}  // namespace mapbed
