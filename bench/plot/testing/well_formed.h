#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mapbed {

// Is this one XML element with all tags closed in order, attributes quoted, no stray '<' or '&'?
// Knows as much of XML as the project's own pictures use: no comments, no declarations.
inline bool is_well_formed(std::string_view xml) {
  std::vector<std::string> open;
  std::size_t elements = 0;
  while (!xml.empty()) {
    const std::size_t begin = xml.find('<');
    const std::string_view text = xml.substr(0, begin);
    if (text.find('>') != std::string_view::npos) return false;
    if (open.empty() && text.find_first_not_of(" \n") != std::string_view::npos) return false;
    for (std::size_t at = text.find('&'); at != std::string_view::npos;
         at = text.find('&', at + 1)) {
      if (text.find(';', at) == std::string_view::npos) return false;
    }
    if (begin == std::string_view::npos) break;
    const std::size_t end = xml.find('>', begin);
    if (end == std::string_view::npos) return false;
    const std::string_view tag = xml.substr(begin + 1, end - begin - 1);
    std::size_t quotes = 0;
    for (const char c : tag) quotes += c == '"' ? 1 : 0;
    if (tag.empty() || quotes % 2 != 0 || tag.find('<') != std::string_view::npos) return false;
    const std::string name(tag.substr(0, tag.find_first_of(" /\n", 1)));
    if (tag.front() == '/') {
      if (open.empty() || "/" + open.back() != name) return false;
      open.pop_back();
    } else {
      elements += open.empty() ? 1 : 0;
      if (tag.back() != '/') open.push_back(name);
    }
    xml.remove_prefix(end + 1);
  }
  return open.empty() && elements == 1;
}

}  // namespace mapbed
