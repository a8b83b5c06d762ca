#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace mapbed {

// An option, or a whole group of them, that has a new name: both are dotted paths, or any part of
// one between two dots ("settling" renames every option below every group of that name).
struct RenamedOption {
  std::string_view old_path;
  std::string_view new_path;
};

// An option, or a group of them, that became a constant; what to do instead.
struct FixedOption {
  std::string_view old_path;
  std::string_view remedy;
};

// Every option that got another name since the last release; looked at only where a key is unknown,
// so that an old file is refused with the new name. A row leaves with the release after next.
std::span<const RenamedOption> renamed_options();

// The path as it is written now, where a row of the table fits a part of it; the longest that fits.
std::optional<std::string> new_path_of(std::string_view path,
                                       std::span<const RenamedOption> renamed = renamed_options());

// "'settling.rounds' is now 'refinement.rounds'" for a path that is unknown, of an option of the
// thing called `context` (may be empty), or that it is no option any more; none where neither is
// so.
std::optional<std::string> renaming_of(std::string_view path, std::string_view context);

}  // namespace mapbed
