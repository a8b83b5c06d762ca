#include "algorithms/localization/free_space.h"

#include <algorithm>
#include <utility>

#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {

FreeSpace::FreeSpace(std::shared_ptr<const OccupancyMap> map) : map_(std::move(map)) {
  CHECK(map_ != nullptr);
  map_->for_each([this](CellIndex cell, const Occupancy& occupancy) {
    if (is_free(occupancy)) cells_.push_back(cell);
  });
}

FreeSpace FreeSpace::near(std::span<const Pose2> poses, double distance) const {
  // Poses by where they are, so that a path of an hour does not cost an hour.
  TiledGrid<std::vector<Eigen::Vector2d>> by_place(distance);
  for (const Pose2& pose : poses) {
    by_place.at(by_place.cell_of(pose.position())).push_back(pose.position());
  }
  const auto is_near = [&](CellIndex cell) {
    const Eigen::Vector2d point = map_->center_of(cell);
    const CellIndex middle = by_place.cell_of(point);
    for (int y = middle.y - 1; y <= middle.y + 1; ++y) {
      for (int x = middle.x - 1; x <= middle.x + 1; ++x) {
        for (const Eigen::Vector2d& pose : by_place[{x, y}]) {
          if ((pose - point).norm() <= distance) return true;
        }
      }
    }
    return false;
  };
  FreeSpace result = *this;
  std::erase_if(result.cells_, [&](CellIndex cell) { return !is_near(cell); });
  return result;
}

double FreeSpace::area() const {
  return static_cast<double>(cells_.size()) * map_->resolution() * map_->resolution();
}

bool FreeSpace::contains(const Eigen::Vector2d& point) const {
  return is_free((*map_)[map_->cell_of(point)]);
}

Pose2 FreeSpace::sample(Rng& rng) const {
  CHECK(!cells_.empty());
  const Eigen::Vector2d corner = map_->frame().corner_of(cells_[rng.index(cells_.size())]);
  const double x = corner.x() + rng.uniform(0.0, map_->resolution());
  const double y = corner.y() + rng.uniform(0.0, map_->resolution());
  return {x, y, rng.uniform(-kPi, kPi)};
}

std::optional<std::string> trouble_at(const OccupancyMap& map, const Eigen::Vector2d& point) {
  const CellIndex cell = map.cell_of(point);
  if (!known_box(map).contains(cell)) return "outside the map";
  if (is_occupied(map[cell])) return "in a wall";
  if (!is_free(map[cell])) return "where nothing is known";
  return {};
}

}  // namespace mapbed
