#include "core/config/yaml_scalar.h"

#include <algorithm>
#include <array>

namespace mapbed {
namespace {

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

bool is_safe_bare(std::string_view text) {
  constexpr std::array<std::string_view, 5> kNulls = {"", "~", "null", "Null", "NULL"};
  if (std::find(kNulls.begin(), kNulls.end(), text) != kNulls.end()) return false;
  const auto harmless = [](char c) {
    return is_letter_or_digit(c) || std::string_view(" ._+-/^%()").find(c) != std::string::npos;
  };
  if (!std::all_of(text.begin(), text.end(), harmless)) return false;
  const bool number_sign = text.size() > 1 && (text[0] == '-' || text[0] == '+' || text[0] == '.');
  const bool good_start =
      is_letter_or_digit(text[0]) || text[0] == '_' || text[0] == '/' ||
      (number_sign && (is_letter_or_digit(text[1]) || text[1] == '.' || text[1] == '/'));
  const bool document_mark = text.starts_with("---") || text.starts_with("...");
  return good_start && !document_mark && text.back() != ' ';
}

std::string escaped(char c) {
  switch (c) {
    case '"':
      return "\\\"";
    case '\\':
      return "\\\\";
    case '\n':
      return "\\n";
    case '\t':
      return "\\t";
    case '\r':
      return "\\r";
    default:
      break;
  }
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= 0x20 && byte != 0x7f) return {c};
  constexpr std::string_view kDigits = "0123456789abcdef";
  return {'\\', 'x', kDigits[byte / 16], kDigits[byte % 16]};
}

}  // namespace

std::string yaml_scalar(std::string_view text) {
  if (is_safe_bare(text)) return std::string(text);
  std::string result = "\"";
  for (const char c : text) result += escaped(c);
  return result + "\"";
}

}  // namespace mapbed
