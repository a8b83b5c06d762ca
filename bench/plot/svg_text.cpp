#include "bench/plot/svg_text.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/check.h"

namespace mapbed {
namespace {

// Bytes of the UTF-8 character at the beginning of `text`; 0 where there is none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  // Overlong forms, surrogates and what is above U+10FFFF.
  if (first == 0xE0 && byte(1) < 0xA0) return 0;
  if (first == 0xED && byte(1) > 0x9F) return 0;
  if (first == 0xF0 && byte(1) < 0x90) return 0;
  if (first == 0xF4 && byte(1) > 0x8F) return 0;
  return length;
}

std::string escaped_ascii(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      break;
  }
  const bool control = (c >= 0 && c < ' ' && c != '\n' && c != '\t') || c == 0x7F;
  return std::string(1, control ? ' ' : c);
}

// DejaVu Sans by Helvetica: at most 1.17 and, bold, 1.33, of lines of more than eight letters.
constexpr double kWiden = 1.2;
constexpr double kBoldWiden = 1.35;
constexpr double kSign = 0.7;

// Of Helvetica, rounded; in units of the font size.
double width_of(char c) {
  constexpr std::string_view kThin = "ijl.,:;'|!I";
  constexpr std::string_view kNarrow = "ftr()[]-/ \"`";
  constexpr std::string_view kWide = "mwMW%@";
  if (kThin.find(c) != std::string_view::npos) return 0.26;
  if (kNarrow.find(c) != std::string_view::npos) return 0.32;
  if (kWide.find(c) != std::string_view::npos) return 0.85;
  return c >= 'A' && c <= 'Z' ? 0.69 : 0.55;
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) {
      result += "\xEF\xBF\xBD";
    } else if (length == 1) {
      result += escaped_ascii(text.front());
    } else {
      result += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return result;
}

std::string coordinate(double value) {
  CHECK(std::isfinite(value));
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

double svg_text_width(std::string_view text, double font_size, FontWeight weight) {
  double width = 0.0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool continues = (byte & 0xC0) == 0x80;
    const bool is_sign = byte == 0xE2;  // of three bytes: minus, dashes, arrows
    if (!continues) width += is_sign ? kSign : width_of(c);
  }
  return width * font_size * (weight == FontWeight::bold ? kBoldWiden : kWiden);
}

double fitting_size(std::string_view text, double font_size, double width, FontWeight weight) {
  const double most = svg_text_width(text, font_size, weight);
  return most > width ? font_size * width / most : font_size;
}

std::vector<std::string> wrapped(std::string_view text, double font_size, double width,
                                 FontWeight weight) {
  std::vector<std::string> lines;
  std::string line;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
    const std::string word(text.substr(0, end));
    const std::string longer = line.empty() ? word : line + " " + word;
    if (!line.empty() && svg_text_width(longer, font_size, weight) > width) {
      lines.push_back(line);
      line = word;
    } else {
      line = longer;
    }
    if (end < text.size() && text[end] == '\n') {
      lines.push_back(line);
      line.clear();
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? static_cast<unsigned>(static_cast<unsigned char>(bytes[i + k]))
                                  : 0U;
    };
    const unsigned three = byte(0) << 16 | byte(1) << 8 | byte(2);
    const std::array<unsigned, 4> digits{three >> 18, three >> 12 & 63, three >> 6 & 63,
                                         three & 63};
    for (std::size_t k = 0; k < 4; ++k) result += i + k <= bytes.size() ? kDigits[digits[k]] : '=';
  }
  return result;
}

std::string png_address(std::string_view png) {
  return "data:image/png;base64," + base64(png);
}

std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 1099511628211ULL;
  }
  return hash;
}

}  // namespace mapbed
