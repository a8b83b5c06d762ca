#include "algorithms/rfid/tag_visibility.h"

#include "algorithms/grid/traversal.h"
#include "algorithms/localization/free_space.h"
#include "algorithms/rfid/line_of_sight.h"

namespace mapbed {
bool is_in_sight(const OccupancyMap& map, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const double distance = (to - from).norm();
  if (distance <= LineOfSight::kThickness) return true;
  const Eigen::Vector2d end = from + (1.0 - LineOfSight::kThickness / distance) * (to - from);
  bool is_open = true;
  const auto look = [&](CellIndex cell, double) {
    if (is_occupied(map[cell])) is_open = false;
  };
  const CoveredCell last = traverse(from, end, map.frame(), look);
  look(last.cell, last.length);
  return is_open;
}

TagVisibility::TagVisibility(const OccupancyMap& map, std::span<const Eigen::Vector2d> tags,
                             double distance)
    : lists_(squares_) {
  map.for_each([&](CellIndex cell, const Occupancy& occupancy) {
    if (!is_free(occupancy)) return;
    const Eigen::Vector2d place = map.frame().center_of(cell);
    std::int32_t& list = lists_.at(lists_.cell_of(place));
    if (list != 0) return;  // by the first of the square's free cells
    std::vector<std::uint32_t>& seen = tags_seen_.emplace_back();
    list = static_cast<std::int32_t>(tags_seen_.size());
    for (std::size_t i = 0; i < tags.size(); ++i) {
      if ((tags[i] - place).norm() > distance || !is_in_sight(map, place, tags[i])) continue;
      seen.push_back(static_cast<std::uint32_t>(i));
    }
  });
}

std::span<const std::uint32_t> TagVisibility::from(const Eigen::Vector2d& place) const {
  const std::int32_t list = lists_[squares_.cell_of(place)];
  if (list == 0) return {};
  return tags_seen_[static_cast<std::size_t>(list - 1)];
}

}  // namespace mapbed
