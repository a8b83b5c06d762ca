#include "core/input_error.h"

namespace mapbed {
namespace {

std::string one_line(const SourceLocation& place, const std::string& reason,
                     const std::string& remedy) {
  std::string text = place.file;
  if (place.line > 0) text += ":" + std::to_string(place.line);
  if (!text.empty()) text += ": ";
  text += reason;
  if (!remedy.empty()) text += "; " + remedy;
  return text;
}

}  // namespace

InputError::InputError(const SourceLocation& place, const std::string& reason,
                       const std::string& remedy)
    : std::runtime_error(one_line(place, reason, remedy)) {}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 80;
  std::string shown;
  for (const char c : text.substr(0, kLongest)) {
    const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    shown += control ? '?' : c;
  }
  return "'" + shown + (text.size() > kLongest ? "…'" : "'");
}

}  // namespace mapbed
