#include "core/config/renamed_options.h"

#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr RenamedOption kRenamed[] = {
    {"settling", "refinement"},
    {"troubles", "input_diagnostics"},
    {"recovery", "wide_search"},
    {"hit_share", "inlier_ratio"},
    {"min_explained", "min_inlier_ratio"},
    {"turn_noise", "rotation_per_rotation"},
    {"turn_per_meter", "rotation_per_meter"},
    {"way_per_meter", "translation_per_meter"},
    {"way_per_turn", "translation_per_rotation"},
    {"floor_turn", "least_rotation_sigma"},
    {"floor_way", "least_translation_sigma"},
    {"turn_bias", "rotation_bias"},
    {"way_bias", "translation_bias"},
};

constexpr char kMatchersOwn[] = "try such values with the method scan_matching, where it is one";
constexpr char kFoundOnce[] = "its value was found once and is the same for all; leave it out";
constexpr char kGrows[] =
    "errors grow with the root of the motion and of time: set 'motion.odometry' and 'motion.slip'";
constexpr char kForAllMethods[] =
    "'input.odometry' holds it for all methods: input.odometry.max_speed, .max_turn_rate";
constexpr FixedOption kFixed[] = {
    {"input_diagnostics.max_speed", kForAllMethods},
    {"input_diagnostics.max_turn_rate", kForAllMethods},
    {"matcher.search_below", kMatchersOwn},
    {"matcher.points", kMatchersOwn},
    {"matcher.field", kMatchersOwn},
    {"matcher.motion", kMatchersOwn},
    {"matcher.climb", kMatchersOwn},
    {"matcher.search", kMatchersOwn},
    {"matcher.recovery", kMatchersOwn},
    {"matcher.icp", kMatchersOwn},
    {"relocalization.scans", kFoundOnce},
    {"relocalization.max_points", kFoundOnce},
    {"relocalization.beam_weight", kFoundOnce},
    {"relocalization.rival_distance", kFoundOnce},
    {"relocalization.rival_turn", kFoundOnce},
    {"relocalization.max_blocks", kFoundOnce},
    {"relocalization.beyond_path", kFoundOnce},
    {"relocalization.field", kFoundOnce},
    {"troubles.standing", kFoundOnce},
    {"motion.position_per_meter", kGrows},
    {"motion.position_per_turn", kGrows},
    {"motion.heading_per_meter", kGrows},
    {"motion.heading_per_turn", kGrows},
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
  for (const FixedOption& row : kFixed) {
    if (find_part(path, row.old_path) == path.npos) continue;
    return in_quotes(path) + " is no option any more; " + std::string(row.remedy);
  }
  if (const auto now = new_path_of(path)) return message(path, *now);
  if (context.empty()) return {};
  const std::string whole = std::string(context) + "." + std::string(path);
  if (const auto now = new_path_of(whole)) return message(whole, *now);
  return {};
}

}  // namespace mapbed
