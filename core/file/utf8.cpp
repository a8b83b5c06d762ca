#include "core/file/utf8.h"

#include <cstddef>

#include <fmt/format.h>

namespace mapbed {
namespace {

bool is_between(unsigned char byte, unsigned least, unsigned most) {
  return byte >= least && byte <= most;
}

// Length of the character that `bytes` begin with, by table 3-7 of the Unicode standard; 0: none.
std::size_t character_length(std::string_view bytes) {
  const auto at = [&](std::size_t i) {  // 0 continues no character
    return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : static_cast<unsigned char>(0);
  };
  const unsigned char first = at(0);
  if (first < 0x80) return 1;
  const std::size_t length = is_between(first, 0xC2, 0xDF)   ? 2
                             : is_between(first, 0xE0, 0xEF) ? 3
                             : is_between(first, 0xF0, 0xF4) ? 4
                                                             : 0;
  // Neither longer than needed, nor half of a surrogate pair, nor beyond the last code point.
  const unsigned least = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned most = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  if (length == 0 || !is_between(at(1), least, most)) return 0;
  for (std::size_t i = 2; i < length; ++i) {
    if (!is_between(at(i), 0x80, 0xBF)) return 0;
  }
  return length;
}

}  // namespace

bool is_utf8(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t length = character_length(bytes);
    if (length == 0) return false;
    bytes.remove_prefix(length);
  }
  return true;
}

std::string escaped_utf8(std::string_view bytes) {
  std::string text;
  while (!bytes.empty()) {
    const std::size_t length = character_length(bytes);
    if (length == 0) {
      text += fmt::format("\\x{:02X}", static_cast<unsigned char>(bytes[0]));
    } else {
      text += bytes.substr(0, length);
    }
    bytes.remove_prefix(length == 0 ? 1 : length);
  }
  return text;
}

}  // namespace mapbed
