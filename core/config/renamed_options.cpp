#include "core/config/renamed_options.h"

#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr RenamedOption kRenamed[] = {
    {"settling", "refinement"},
};

// Where `part` stands in `path` with dots or nothing around it; npos where it does not.
std::size_t find_part(std::string_view path, std::string_view part) {
  for (std::size_t at = path.find(part); at != path.npos; at = path.find(part, at + 1)) {
    const std::size_t end = at + part.size();
    if ((at == 0 || path[at - 1] == '.') && (end == path.size() || path[end] == '.')) return at;
  }
  return path.npos;
}

}  // namespace

std::span<const RenamedOption> renamed_options() {
  return kRenamed;
}

std::optional<std::string> new_path_of(std::string_view path,
                                       std::span<const RenamedOption> renamed) {
  const RenamedOption* best = nullptr;
  for (const RenamedOption& row : renamed) {
    if (find_part(path, row.old_path) == path.npos) continue;
    if (best == nullptr || row.old_path.size() > best->old_path.size()) best = &row;
  }
  if (best == nullptr) return {};
  std::string result(path);
  result.replace(find_part(path, best->old_path), best->old_path.size(), best->new_path);
  return result;
}

std::optional<std::string> renaming_of(std::string_view path, std::string_view context) {
  const auto message = [](std::string_view old_path, const std::string& new_path) {
    return in_quotes(old_path) + " is now " + in_quotes(new_path);
  };
  if (const auto now = new_path_of(path)) return message(path, *now);
  if (context.empty()) return {};
  const std::string whole = std::string(context) + "." + std::string(path);
  if (const auto now = new_path_of(whole)) return message(whole, *now);
  return {};
}

}  // namespace mapbed
