#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/config/permitted_values.h"
#include "core/config/set_option.h"
#include "core/config/settings.h"
#include "core/config/yaml_scalar.h"
#include "core/file/tokens.h"

namespace mapbed {
namespace {

// What stands behind the value: what it is and, where that is asked for, what else it may be.
std::string comment_of(const Option& option) {
  const std::string permitted = PermittedValuesShown::now() ? permitted_values(option) : "";
  const bool both = !option.about.empty() && !permitted.empty();
  return option.about + (both ? "; " : "") + permitted;
}

std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> parts;
  for (std::size_t start = 0;;) {
    const std::size_t dot = path.find('.', start);
    parts.push_back(path.substr(start, dot - start));
    if (dot == std::string::npos) return parts;
    start = dot + 1;
  }
}

}  // namespace

std::string to_yaml(const OptionList& options) {
  std::string yaml;
  std::vector<std::string> open;  // the groups around the line that was written last
  for (const Option& option : options) {
    const std::vector<std::string> parts = split(option.path);
    const std::size_t depth = parts.size() - 1;
    const auto differs = std::mismatch(open.begin(), open.end(), parts.begin(),
                                       parts.begin() + static_cast<std::ptrdiff_t>(depth));
    auto same = static_cast<std::size_t>(differs.first - open.begin());
    open.assign(parts.begin(), parts.end() - 1);
    for (; same < depth; ++same) yaml += std::string(2 * same, ' ') + parts[same] + ":\n";
    yaml += std::string(2 * depth, ' ') + parts.back() + ": " + option_text(option);
    const std::string comment = comment_of(option);
    yaml += comment.empty() ? "\n" : "  # " + comment + "\n";
  }
  return yaml;
}

std::string dotted(const std::string& group, std::string_view yaml) {
  constexpr std::size_t kIndent = 2;
  std::vector<std::string> path;
  const std::size_t above = group.empty() ? 0 : 1;
  if (above > 0) path.push_back(group);
  std::string text;
  while (!yaml.empty()) {
    const std::string line(next_line(yaml));
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string::npos) continue;
    const std::size_t colon = line.find(':', begin);
    path.resize(begin / kIndent + above);
    path.push_back(line.substr(begin, colon - begin));
    const std::string value = line.substr(colon + 1);
    if (!value.empty()) text += fmt::format("{}:{}\n", fmt::join(path, "."), value);
  }
  return text;
}

std::string indented(std::string_view yaml, int blanks) {
  const std::string margin(static_cast<std::size_t>(blanks), ' ');
  std::string result;
  while (!yaml.empty()) result += margin + std::string(next_line(yaml)) + "\n";
  return result;
}

}  // namespace mapbed
