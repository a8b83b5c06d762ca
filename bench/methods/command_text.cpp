#include "bench/methods/command_text.h"

#include <algorithm>
#include <string_view>

#include "core/check.h"
#include "core/config/suggestion.h"

namespace mapbed {
namespace {

bool is_of_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

// The name that begins with this brace; empty where none does.
std::string_view name_at(std::string_view text, std::size_t brace) {
  std::size_t end = brace + 1;
  while (end < text.size() && is_of_name(text[end])) ++end;
  const bool is_name = end > brace + 1 && end < text.size() && text[end] == '}';
  return is_name ? text.substr(brace + 1, end - brace - 1) : std::string_view();
}

// Calls `plain` for each character of the text's own and `name` for each placeholder.
template <class Plain, class Name>
void walk(std::string_view text, Plain&& plain, Name&& name) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool is_double = (c == '{' || c == '}') && i + 1 < text.size() && text[i + 1] == c;
    const std::string_view found = c == '{' && !is_double ? name_at(text, i) : std::string_view();
    if (!found.empty()) {
      name(std::string(found));
      i += found.size() + 1;
    } else {
      plain(c);
      if (is_double) ++i;
    }
  }
}

std::string in_shell_quotes(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

template <class Write>
std::string filled_by(const std::string& text, const Placeholders& values, Write&& write) {
  std::string result;
  walk(
      text, [&](char c) { result += c; },
      [&](const std::string& name) {
        const auto value = values.find(name);
        CHECK(value != values.end());
        result += write(value->second);
      });
  return result;
}

}  // namespace

std::vector<std::string> placeholders_in(const std::string& text) {
  std::vector<std::string> names;
  walk(
      text, [](char) {}, [&](std::string name) { names.push_back(std::move(name)); });
  return names;
}

std::string filled(const std::string& text, const Placeholders& values) {
  return filled_by(text, values, [](const std::string& value) { return value; });
}

std::string filled_for_shell(const std::string& text, const Placeholders& values) {
  return filled_by(text, values, in_shell_quotes);
}

void check_placeholders(const std::string& text, const std::vector<std::string>& known,
                        const SourceLocation& place) {
  for (const std::string& name : placeholders_in(text)) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw InputError(place, "unknown placeholder '{" + name + "}'", suggestion(name, known));
  }
}

}  // namespace mapbed
