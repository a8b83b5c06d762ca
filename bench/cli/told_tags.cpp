#include "bench/cli/told_tags.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "algorithms/rfid/tag_answer.h"
#include "algorithms/rfid/tags_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr double kBeside = 2.0;  // [m] of the map's edge: a tag on the outer side of a wall

}  // namespace

std::vector<TagBelief> tags_on_map(const std::string& path, const OccupancyMap& map) {
  std::vector<TagBelief> tags = load_tags(path);
  const CellBox box = known_box(map);
  const Eigen::Vector2d room(kBeside, kBeside);
  const Eigen::Vector2d low = map.frame().corner_of(box.min) - room;
  const Eigen::Vector2d high = map.frame().corner_of({box.max.x + 1, box.max.y + 1}) + room;
  const bool is_elsewhere = std::none_of(tags.begin(), tags.end(), [&](const TagBelief& tag) {
    const Eigen::Vector2d place = answer_of(tag).most_likely;
    return (place.array() >= low.array()).all() && (place.array() <= high.array()).all();
  });
  if (!is_elsewhere) return tags;
  throw InputError({path}, "none of its tags lies on the map", "take the tags of this place");
}

void check_has_rounds(const std::string& log_path, const SensorLog& log) {
  const bool has = std::any_of(log.begin(), log.end(), [](const Measurement& measurement) {
    return std::holds_alternative<RfidDetections>(measurement);
  });
  if (has) return;
  throw InputError({log_path}, "has no round of an RFID reader, and tags are given",
                   "leave --tags out, or take a log with RFID lines");
}

std::vector<Remark> remarks_on_tags(const std::string& path, const std::vector<TagBelief>& tags,
                                    const SensorLog& log) {
  std::set<std::string> known, heard, strange;
  for (const TagBelief& tag : tags) known.insert(tag.tag);
  for (const Measurement& measurement : log) {
    const auto* round = std::get_if<RfidDetections>(&measurement);
    if (round == nullptr) continue;
    for (const RfidRead& read : round->reads) {
      (known.contains(read.tag) ? heard : strange).insert(read.tag);
    }
  }
  std::vector<Remark> remarks;
  if (heard.empty()) {
    remarks.push_back(
        {RemarkKind::note,
         fmt::format("none of the {} tags of {} answers in this log", tags.size(), path)});
  }
  if (!strange.empty()) {
    remarks.push_back(
        {RemarkKind::note,
         fmt::format("{} tags answer that {} does not know, first of all {}: they say "
                     "nothing",
                     strange.size(), path, *strange.begin())});
  }
  return remarks;
}

}  // namespace mapbed
